"""What a hand does in the player: it drags the crank, follows points and curves, guesses before it looks."""

from __future__ import annotations

from itertools import product
from math import hypot
from pathlib import Path

import pytest

from tests.chromium import Page
from tests.laws import few
from tests.player.pages import DESK, PHONE, PLACES, data, page_of

KINEMATICS, CENTRES, FORCES = "3-9", "3-1d", "4-3a"
LEAST = 11.0  # pixels of the smallest letter
SMALLEST = """(() => {
  const frame = paper.getBoundingClientRect(), sizes = [];
  for (const use of all(player.turning() ? "#turned use" : "#drawn use")) {
    const box = use.getBoundingClientRect(), { f } = letters.of(use.getAttribute("href").slice(1));
    const seen = box.width && box.right > frame.left && box.left < frame.right && box.top < frame.bottom;
    if (seen && !use.closest(".halo, .aside")) sizes.push(f * use.getScreenCTM().a);
  }
  return Math.min(...sizes); })()"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("hand")
    for name in (KINEMATICS, CENTRES, FORCES):
        (made / f"{name}.html").write_text(page_of(name), encoding="utf-8")
    return made


def show(page: Page, folder: Path, where: str, size: tuple[int, int] = DESK) -> Page:
    name, _, place = where.partition("#")
    page.open(f"{(folder / name).as_uri()}.html#{place}", *size, touch=size == PHONE)
    page.wait("player.ready")
    page.value(ONCE)
    return page


def mouse(page: Page, kind: str, x: float, y: float) -> None:
    page.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)


ON_SCREEN = """((letter, index) => { const f = turn.figures[0], p = f.points.find((one) => one.letter === letter);
  return onScreen(f, ...trace.spot(p, index)); })"""
ONCE = """function onScreen(figure, x, y) {
  const z = new DOMPoint(x, y).matrixTransform(figure.node.getScreenCTM()); return [z.x, z.y]; }"""


def test_the_crank_follows_the_mouse_between_the_places_too(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#turn=1")
    start, end = data(page, f"{ON_SCREEN}('B', 1)"), data(page, f"{ON_SCREEN}('B', 3.4)")
    mouse(page, "mousePressed", *start)
    for k in (0.3, 0.6, 0.8, 1.0):
        mouse(page, "mouseMoved", *((1 - k) * a + k * b for a, b in zip(start, end, strict=True)))
    assert page.value("player.place") == pytest.approx(3.4, abs=0.1) and page.value("player.view") == "auto"
    mouse(page, "mouseReleased", *end)
    assert page.value("trace.held === null && !document.documentElement.hasAttribute('data-held')")
    told = page.value("one('#degrees').textContent")
    assert float(told.rstrip("°")) == pytest.approx((45 - 60 * 3.4) % 360, abs=6.0)
    assert page.value("all('#turn td:last-child').some((cell) => cell.textContent.startsWith('≈'))")


def test_the_crank_follows_a_finger(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#turn=1", PHONE)
    start, end = data(page, f"{ON_SCREEN}('B', 1)"), data(page, f"{ON_SCREEN}('B', 3)")
    ways = [start, *([(1 - k) * a + k * b for a, b in zip(start, end, strict=True)] for k in (0.3, 0.6, 1.0))]
    for kind, spots in (("touchStart", ways[:1]), *(("touchMove", [at]) for at in ways[1:]), ("touchEnd", [])):
        page.send("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": 0} for x, y in spots])
    assert page.value("player.place") == pytest.approx(3, abs=0.15) and page.value("trace.held === null")
    assert page.value("player.view") == "auto", "it is no pan"


def test_between_two_places_a_crank_keeps_its_length_and_a_path_passes_its_points(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#turn=0")
    crank = data(page, "turn.figures[0].points.find((one) => one.letter === 'B').at")
    length = hypot(*crank[0])
    for index in (0.5, 2.25, 5.5):
        x, y = data(page, f"trace.spot(turn.figures[0].points.find((one) => one.letter === 'B'), {index})")
        assert hypot(x, y) == pytest.approx(length, rel=0.03), "a straight way would be 13 % short"
    page.value("one('#ways button[data-letter=E]').click(); 0")
    way = data(page, "one('.way').getAttribute('d').match(/-?[\\d.]+/g).map(Number)")
    spots = set(zip(way[::2], way[1::2], strict=True))
    assert {tuple(at) for at in data(page, "turn.figures[0].points.find((one) => one.letter === 'E').at")} <= spots
    page.value("one('#ways button[data-letter=E]').click(); 0")
    assert page.value("all('.way').length") == 0


def test_what_is_drawn_between_two_places_lies_between_them(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{FORCES}#turn=0")
    pairs = data(
        page,
        "turn.figures.flatMap((f) => f.sets.flatMap((s) => [0, 1, 2].flatMap((i) => s.moving[i] && s.moving[i + 1] ? "
        "Object.keys(s.moving[i]).map((layer) => { const [a, b] = [i, i + 1].map((k) => pieces(s.moving[k][layer]));"
        " return [a.length, blended([null, a, b, null], 0.25).length, likes(a, b).size]; }) : [])))",
    )
    assert pairs and all(shown == count for count, shown, _ in pairs), "nothing is lost on the way"
    assert sum(alike for *_, alike in pairs) > 0.9 * sum(count for count, *_ in pairs), "nearly all of it moves"


def test_a_curve_shows_a_quantity_over_the_turn_and_leads_to_a_place(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#turn=0")
    page.value("one('#turn tr:nth-child(4) .pick').click(); 0")  # omega_2
    shown, exact = data(page, "all('#curve .dots circle').length"), data(page, "turn.data.curves[3].exact")
    assert shown == len(exact) == PLACES and min(exact) < 0
    box = data(page, "one('#curve svg').getBoundingClientRect()")
    x = box["left"] + box["width"] * page.value("curve.x(6) / curve.W")
    mouse(page, "mousePressed", x, box["top"] + box["height"] / 2)
    assert page.value("player.place") == pytest.approx(6, abs=0.1)
    assert all(low <= page.value(f"curve.about(3, {i} + 0.5)") <= high for i in range(PLACES - 1)
               for low, high in [sorted(exact[i : i + 2])])  # fmt: skip


def test_a_guess_is_asked_for_before_the_point_is_shown(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#step=4.1")
    page.press("g", "g")
    page.press("ArrowRight")
    assert page.value("guess.veiled && !one('#ask').hidden && all('#drawn .now').length === 0")
    x, y = data(page, "onScreen(figures[1], ...beat.of(player.beat).at.slice(1).map((v, k) => v + (k ? 0 : 500)))")
    mouse(page, "mousePressed", x, y)
    mouse(page, "mouseReleased", x, y)
    before = page.value("player.beat")
    page.press("ArrowRight")
    assert page.value("player.beat") == before and page.value("!guess.veiled && all('#drawn .now').length") > 0
    told = page.value("one('#told-guess').textContent")
    assert " 5.0 mm" in told and "0.030 m/s" in told, "five millimetres at 0.006 (m/s)/mm"
    page.press("ArrowRight")
    assert page.value("player.beat") == before + 1 and page.value("one('#told-guess').textContent") == ""


def test_an_own_reading_is_answered_with_its_deviation(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#step=4&lang=en")
    page.press("g", "g")
    page.press("ArrowRight")  # l_BC: the length BC is to be measured
    length = page.value("guess.length(cut[player.beat - 1])")
    assert page.value("!one('#ask-read').hidden && all('#steps li.cur .display:not(.later)').length === 0")
    page.value(f"one('#own-reading').value = '{length + 0.9:.2f}'; one('#unveil').click(); 0")
    assert page.value("one('#told-guess').textContent") == (
        f"It is {length:.1f} mm long; your reading is off by +0.9 mm (+{90 / length:.2g} %)."
    )
    assert length == pytest.approx(abs(-100 - 30 * (1 + 1j) / 2**0.5) / 2, abs=0.2), "BC, at 0.002 m/mm"


@pytest.mark.parametrize("calm", [False, True])
def test_the_relative_velocity_turns_into_the_coriolis_term(calm: bool, chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#step=9.4")
    page.send(
        "Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}] if calm else []
    )
    at = page.value("cut.findIndex((one) => one.turn) + 1")
    page.value("performance.now = () => -5000; 0")  # what begins now has lasted five seconds at the next picture
    assert page.value(f"player.go({at}); all('.turned path').length") == (2 if calm else 3)
    assert page.value("all('.turned .ghost, .turned .bow').length") == 2
    assert page.wait("all('.turned path').length === 2"), "it comes to rest"
    assert page.value("cut[player.beat - 1].turn[5]") == pytest.approx(90, abs=0.2)


WHERES = (f"{KINEMATICS}#step=9", f"{CENTRES}#turn=4", f"{KINEMATICS}#turn=3", f"{FORCES}#turn=2")


@pytest.mark.parametrize(("where", "size"), few([*product(WHERES, (DESK, PHONE))], 4))
def test_every_letter_can_be_read_and_no_chip_is_cut_off(
    where: str, size: tuple[int, int], chrome: Page, folder: Path
) -> None:
    page = show(chrome, folder, where, size)
    assert page.value(SMALLEST) > LEAST
    chips = "all('#views button, #view, #ways button').filter((b) => b.offsetParent)"
    sides = data(page, f"{chips}.map((b) => b.getBoundingClientRect()).map((r) => [r.left, r.right])")
    assert sides and all(left >= 0 and right <= size[0] for left, right in sides)


@pytest.mark.parametrize("size", few([DESK, PHONE], 2))
def test_all_polygons_are_followed_and_fill_their_frames(size: tuple[int, int], chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{KINEMATICS}#turn=2", size)
    shown = "turn.figures.filter((f) => f.node.style.display !== 'none')"
    assert data(page, f"{shown}.map((f) => f.key)") == ["mechanism", "velocity", "acceleration"]
    followed = f"{shown}.filter((f) => f.cell)"
    for index in range(0, PLACES, 3):
        page.value(f"player.go({index}); 0")
        for frame, near, box in data(page, f"{followed}.map((f) => [f.frame, f.near, turn.taken(f, {index})])"):
            assert near * (box[2] - box[0]) < frame[2] and near * (box[3] - box[1]) < frame[3]
        assert data(page, f"{followed}.map((f) => f.near)") != [1, 1]
    page.value("player.look('all'); 0")
    assert data(page, "turn.figures.map((f) => f.near)") == [1, 1, 1], "seen all together they truly grow and shrink"


def test_a_point_off_the_sheet_is_told_to_be_there(chrome: Page, folder: Path) -> None:
    page = show(chrome, folder, f"{CENTRES}#turn=0")
    told = set()
    for index in range(PLACES):
        page.value(f"player.go({index}); 0")
        off = data(page, "turn.figures.filter((f) => f.off).flatMap((f) => f.off)")
        arrows = page.value("all('.far .edge').length")
        assert arrows == len(off) and page.value("one('#off').hidden") is (
            page.value("one('#off-list').innerHTML") == ""
        )
        told |= {page.value("one('#off-list').textContent"), *off}
    assert told - {""}

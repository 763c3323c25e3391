"""Letters that grow for a small window keep out of each other; paths pass the points that they are paths of."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.chromium import Page
from tests.laws import few
from tests.player.pages import DESK, PHONE, PLACES, data, page_of, solved
from vecpoly.board.paper.marks import Point
from vecpoly.player.figures import key_of
from vecpoly.player.turned import cycle

KINEMATICS, MANY_SCALES = "3-9", "B-24"
LEAST, OVER = 11.0, 1.5  # pixels: of a letter; that two may be over each other
INKS = """(() => { const found = [];
  for (const use of all(player.turning() ? "#turned use" : "#drawn use")) {
    if (use.closest(".halo, .aside, .off") || !use.getBoundingClientRect().width) continue;
    const { w, h, f } = letters.of(use.getAttribute("href").slice(1)), at = use.getScreenCTM();
    const [x, y] = ["x", "y"].map((name) => +(use.getAttribute(name) || 0));
    const [a, b] = [new DOMPoint(x, y - h), new DOMPoint(x + w, y)].map((corner) => corner.matrixTransform(at));
    found.push([a.x, a.y, b.x, b.y, f * at.a]);
  }
  return found; })()"""


WAYS = "turn.figures.map((f) => [f.key, f.ways.getAttribute('transform'), f.points.map((p) => [p.letter, p.at[{}]])])"
SIDES = "turn.figures.map(({ key }) => stage.spots.get(key)).map(({ w, h }) => [w, h])"


def show(page: Page, folder: Path, name: str, where: str, size: tuple[int, int]) -> Page:
    file = folder / f"{name}.html"
    file.write_text(page_of(name), encoding="utf-8")
    page.open(f"{file.as_uri()}#{where}", *size, touch=size == PHONE)
    page.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
    page.wait("player.ready")
    return page


def overlaps(inks: list[list[float]]) -> int:
    """How many pairs of pieces of type lie over each other."""
    return sum(
        min(a[2], b[2]) - max(a[0], b[0]) > OVER and min(a[3], b[3]) - max(a[1], b[1]) > OVER
        for i, a in enumerate(inks)
        for b in inks[:i]
    )


@pytest.mark.parametrize(("lang", "size"), few([("zh", DESK), ("zh", PHONE), ("en", DESK), ("en", PHONE)], 4))
def test_letters_stand_apart_at_every_step_and_place_and_can_be_read(
    lang: str, size: tuple[int, int], chrome: Page, tmp_path: Path
) -> None:
    page = show(chrome, tmp_path, KINEMATICS, f"step=1&lang={lang}", size)
    for mode, places in (("steps", range(2, page.value("cut.length") + 1, 4)), ("turn", range(0, PLACES, 2))):
        page.value(f"player.setMode('{mode}'); 0")
        for place in places:
            page.value(f"player.go({place}); player.frame(true); 0")
            inks = data(page, INKS)
            assert inks and overlaps(inks) == 0, (mode, place)
            assert min(ink[4] for ink in inks) > LEAST, (mode, place)


def test_a_letter_and_its_glow_stand_at_one_place(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, KINEMATICS, "step=1", PHONE)
    page.value("player.go(cut.findIndex(({ at }) => at && at[0] === 'velocity') + 2); player.frame(true); 0")
    of = "((use) => ['href', 'x', 'y'].map((name) => use.getAttribute(name)).join(' '))"
    placed = f"((uses) => uses.map((use) => [{of}(use), use.getAttribute('transform')]))"
    glows, own = (
        data(page, f"{placed}(figures.flatMap(({{ node }}) => all('{which}', node)))")
        for which in (".halo use", "[data-step] use")
    )
    letters = dict(own)
    assert glows and all(letters[name] == moved for name, moved in glows) and any(moved for _, moved in glows)


def test_a_path_passes_its_point_at_whatever_scale_a_place_is_drawn(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, MANY_SCALES, "turn=0", DESK)
    page.value("player.look('all'); 0")
    assert min(data(page, "turn.figures.flatMap((f) => f.sizes)")) < 0.6, "some places are drawn at a coarser scale"
    compared = 0
    for place, turn in enumerate(cycle(solved(MANY_SCALES), PLACES).turns):
        page.value(f"player.go({place}); 0")
        for key, moved, points in data(page, WAYS.format(place)):
            times = float(moved.removeprefix("scale(").removesuffix(")"))
            marks = next(one.marks for one in turn.solution.construction.figures if key_of(one) == key)
            drawn = {mark.label: mark.at for mark in marks if isinstance(mark, Point)}
            for letter, (x, y) in ((letter, at) for letter, at in points if at):
                assert complex(x, -y) * times / 100 == pytest.approx(drawn[letter], abs=0.02), (place, key, letter)
                compared += times != 1
    assert compared > 10


def test_no_point_that_is_drawn_inside_its_frame_is_told_to_be_off_the_sheet(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, MANY_SCALES, "turn=0", DESK)
    page.value("player.look('all'); 0")
    for place in range(PLACES):
        page.value(f"player.go({place}); 0")
        assert (
            data(page, "turn.figures.filter((f) => f.polygon && !turn.data.figures[0].cut).flatMap((f) => f.off)") == []
        )


def test_on_a_phone_the_figures_take_most_of_the_room(chrome: Page, tmp_path: Path) -> None:
    page = show(chrome, tmp_path, KINEMATICS, "turn=2", PHONE)
    frame = data(page, "(({ width, height }) => [width, height])(paper.getBoundingClientRect())")
    pixels = page.value("stage.size().w / stage.camera.w")
    assert sum(w * h for w, h in data(page, SIDES)) * pixels**2 > 0.55 * frame[0] * frame[1]

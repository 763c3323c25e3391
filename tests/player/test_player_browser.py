"""The step player in headless Chromium: it goes through everything,
by key and finger, on phones and projectors, and can be read."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.chromium import Page
from tests.laws import few
from tests.player.pages import PLACES, page_of, solved
from vecpoly.player.beats import beats, stepped
from vecpoly.player.turned import cycle

KINEMATICS, FORCES, DEVICE = "3-9", "4-3a", "5-5"


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("player")
    for name in (KINEMATICS, FORCES, DEVICE):
        (folder / f"{name}.html").write_text(page_of(name), encoding="utf-8")
    return folder


@pytest.fixture
def page(chrome: Page) -> Page:
    return chrome


@pytest.mark.parametrize("name", few([KINEMATICS, FORCES, DEVICE], 3))
def test_the_page_goes_through_all_steps_and_places(name: str, files: Path, page: Page) -> None:
    page.open(f"{(files / name).as_uri()}.html#selftest=4")
    found = json.loads(page.wait("document.documentElement.dataset.selftest"))
    cut = beats(solved(name).construction)
    count = len(cut)
    drawing = {mark.step for figure in stepped(solved(name).construction).figures for mark in figure.marks}
    assert found["errors"] == [] and found["loads"] == 0 and found["unnamed"] == 0
    assert [(one["lang"], one["step"]) for one in found["steps"]] == [
        (lang, n) for lang in ("zh", "en") for n in range(1, count + 1)
    ]
    for one in found["steps"]:
        assert one["shown"] and one["now"] == one["marked"] and (one["now"] > 0) == (one["step"] in drawing), one
        assert one["current"] == 1 and one["slider"] == one["step"] and one["said"] >= 3 and one["text"] > 5
        assert one["whole"] == cut[one["step"] - 1].step
    assert found["keys"] == [1, 2, 3, 2, count, 1] and found["zoomed"]
    turns = cycle(solved(name), PLACES).turns
    assert [place["angle"] for place in found["places"]] == [turn.shown for turn in turns[::4]]
    assert all(place["paths"] > 10 and place["readings"] == 3 * len(solved(name).answers) for place in found["places"])


def test_keys_play_stop_and_leave_the_slider_its_own(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html")
    page.wait("player.ready")
    page.press("ArrowRight")
    page.press("ArrowRight")
    assert page.value("player.beat") == 3
    page.press(" ", " ")
    assert page.value("document.documentElement.hasAttribute('data-playing')")
    page.press(" ", " ")
    assert not page.value("document.documentElement.hasAttribute('data-playing')")
    page.value("document.querySelector('#paper').focus()")
    width = page.value("stage.camera.w")
    page.press("+", "+")
    assert page.value("stage.camera.w") < width and page.value("player.view") == "free"
    page.press("0", "0")
    assert page.wait(f"stage.camera.w > {0.9 * width}")


def test_a_presenter_may_press_what_is_at_hand(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html")
    page.wait("player.ready")
    page.value("one('#slider').focus()")
    page.press("PageDown")  # a remote control sends it wherever the focus is
    page.press("PageDown")
    assert page.value("player.beat") == 3
    page.value("one('#last').click(); one('#next').focus()")
    assert page.value("[document.activeElement.id, one('#next').getAttribute('aria-disabled')]") == [
        "next",
        "true",
    ]  # the focus is not lost at the end
    page.value("one('#larger').click(); one('#panel-off').click(); one('#speed').click(); 0")
    assert page.value(
        "[root.style.fontSize, root.dataset.panel, player.speed, one('#panel-off').getAttribute('aria-label')]"
    ) == ["125%", "off", 2, "展开说明"]
    assert (
        page.value("all('#steps li').filter((n) => n.offsetParent).length") == 1
    )  # the sentence of the step stays under the drawing
    assert page.value("document.documentElement.scrollWidth <= innerWidth")


def test_a_press_is_no_pan_and_new_lines_are_never_out_of_sight(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html")
    page.wait("player.ready")
    drag(page, 300, 302)
    assert page.value("player.view") == "auto"
    drag(page, 300, 400)
    assert page.value("player.view") == "free"
    page.value("player.look('auto'); player.go(2); stage.zoom(6, 0.1, 0.1); 0")
    assert page.value("player.view") == "free"
    page.value("player.go(4); 0")  # in another figure
    assert page.value("player.view") == "auto"


def drag(page: Page, start: int, end: int) -> None:
    for kind, x in (("mousePressed", start), ("mouseMoved", end), ("mouseReleased", end)):
        page.send("Input.dispatchMouseEvent", type=kind, x=x, y=300, button="left", buttons=1, clickCount=1)


def test_two_fingers_zoom_the_sheet(files: Path, page: Page) -> None:
    page.open(f"{(files / DEVICE).as_uri()}.html", 390, 844, touch=True)
    page.wait("player.ready")
    before = page.value("stage.camera.w")
    for kind, spots in (("touchStart", (150, 250)), ("touchMove", (100, 300)), ("touchEnd", ())):
        page.send(
            "Input.dispatchTouchEvent",
            type=kind,
            touchPoints=[{"x": x, "y": 250, "id": i} for i, x in enumerate(spots)],
        )
    assert page.value("stage.camera.w") == pytest.approx(before / 2, rel=0.01) and page.value("pointers.size") == 0


def test_an_address_leads_to_a_step_or_a_place(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html#step=7&lang=en")
    page.wait("player.ready")
    shown = "[player.mode, one('#counter').textContent, root.dataset.lang]"
    assert page.value(shown) == ["steps", "7 / 12", "en"]
    for link, found in (
        ("step=99", "12 / 12"),
        ("step=9.3", "9.3 / 12"),
        ("step=x", "9.3 / 12"),
        ("turn=2", "285°"),
        ("turn=-9", "225°"),  # nine back of six are three on
    ):
        page.value(
            f"location.hash = '{link}'; new Promise((done) => addEventListener('hashchange', () => "
            "setTimeout(done), { once: true }))"
        )
        assert page.value(shown)[1] == found, link


def test_one_scale_is_shown_under_each_figure_and_another_than_the_given_one_is_marked(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html#turn=0")
    page.wait("player.ready")
    for place in range(0, PLACES, 3):
        page.value(f"player.go({place}); 0")
        assert page.value("turn.figures.map((f) => f.captions.filter((c) => c.style.display !== 'none').length)") == [
            1,
            1,
            1,
        ]
    marked = page.value("turn.data.figures.some((f) => f.captions.some(({ other }) => other))")
    assert page.value("one('#others').hidden") is not marked


def test_text_of_twice_the_size_loses_no_control(files: Path, page: Page) -> None:
    page.open(f"{(files / FORCES).as_uri()}.html", 390, 844, touch=True)
    page.wait("player.ready")
    page.value("root.style.fontSize = '200%'; player.setLang('en'); 0")
    assert page.value("document.documentElement.scrollWidth") <= 390
    assert page.value(
        "all('footer button, header button').filter((b) => b.offsetParent).every((b) => { const r = "
        "b.getBoundingClientRect(); return r.width > 36 && r.left >= 0 && r.right <= innerWidth; })"
    )
    assert page.value("stage.size().h") > 100


@pytest.mark.parametrize(("width", "height"), few([(390, 844), (844, 390), (320, 640), (1280, 800), (1920, 1080)], 3))
def test_nothing_sticks_out_of_the_window_and_fingers_can_hit_the_controls(
    width: int, height: int, files: Path, page: Page
) -> None:
    page.open(f"{(files / FORCES).as_uri()}.html", width, height, touch=width < 900)
    page.wait("player.ready")
    for mode in ("steps", "turn"):
        page.value(f"player.setMode('{mode}'); 0")
        assert page.value("document.documentElement.scrollWidth") <= width
        small = page.value(
            "all('footer button, #zoom button').filter(b => { const r = b.getBoundingClientRect(); return "
            "r.width < 36 || r.height < 36 || r.right > innerWidth || r.bottom > innerHeight; }).length"
        )
        assert small == 0
        assert page.value("stage.size().h") > 0.2 * height


def test_a_figure_that_is_shown_fits_the_window(files: Path, page: Page) -> None:
    page.open(f"{(files / FORCES).as_uri()}.html", 390, 844, touch=True)
    page.wait("player.ready")
    shown = page.value(
        "cut.map((_, n) => { player.go(n + 1); player.frame(true); const c = stage.camera; return figures.filter("
        "f => !f.node.classList.contains('aside') && f.steps[0] <= player.beat).map(f => stage.spots.get(f.key)).map("
        "b => b.x >= c.x && b.y >= c.y && b.x + b.w <= c.x + c.w && b.y + b.h <= c.y + c.h); })"
    )
    assert len(shown) == len(beats(solved(FORCES).construction)) and shown[-1]
    assert all(all(step) for step in shown), shown


def test_text_stands_out_from_its_ground(files: Path, page: Page) -> None:
    """WCAG: 4.5 to 1 for text, by day and by night."""
    script = """(() => {
      const straight = (v) => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
      const light = (c) => {
        const [r, g, b] = c.match(/[\\d.]+/g).map((v) => straight(v / 255));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const ground = (n) => {
        for (; n; n = n.parentElement) {
          const c = getComputedStyle(n).backgroundColor;
          if (!/, 0\\)|transparent/.test(c)) return c;
        }
        return "rgb(255,255,255)";
      };
      const seen = all("h1, h2, .words, li, button, summary, .note, td, th, output").filter((n) => n.offsetParent);
      return seen.map((n) => {
        const a = light(getComputedStyle(n).color), b = light(ground(n));
        return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), n.outerHTML.slice(0, 60)];
      }).filter(([ratio]) => ratio < 4.5); })()"""
    for scheme in ("light", "dark"):
        page.open(f"{(files / KINEMATICS).as_uri()}.html")
        page.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        page.wait("player.ready")
        page.value("player.go(5); 0")
        assert page.value(script) == [], scheme

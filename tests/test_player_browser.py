"""The step player in headless Chromium: it goes through everything, by key and finger, on phones and projectors, and can be read."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from chromium import Page, browser, chromium

from vecpoly.player.page import player_html
from vecpoly.player.turned import cycle
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve

pytestmark = pytest.mark.skipif(browser() is None, reason="no chromium or chrome on this machine")
KINEMATICS, FORCES, DEVICE = "3-9", "4-3a", "5-5"
PLACES = 24


@cache
def solved(name: str) -> Solution:
    return solve(load(name), repeats=0)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("player")
    for name in (KINEMATICS, FORCES, DEVICE):
        (folder / f"{name}.html").write_text(player_html(solved(name), places=PLACES), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def page() -> Iterator[Page]:
    with chromium() as opened:
        yield opened


@pytest.mark.parametrize("name", [KINEMATICS, FORCES, DEVICE])
def test_the_page_goes_through_all_steps_and_places(name: str, files: Path, page: Page) -> None:
    page.open(f"{(files / name).as_uri()}.html#selftest=8")
    found = json.loads(page.wait("document.documentElement.dataset.selftest"))
    count = len(solved(name).construction.steps)
    drawing = {mark.step for figure in solved(name).construction.figures for mark in figure.marks}
    assert found["errors"] == [] and found["loads"] == 0 and found["unnamed"] == 0
    assert [(one["lang"], one["step"]) for one in found["steps"]] == [(lang, n) for lang in ("zh", "en") for n in range(1, count + 1)]
    for one in found["steps"]:
        assert one["shown"] and one["now"] == one["marked"] and (one["now"] > 0) == (one["step"] in drawing), one
        assert one["current"] == 1 and one["slider"] == one["step"] and one["said"] > 10 and one["text"] > 5
    assert found["keys"] == [1, 2, 3, 2, count, 1] and found["zoomed"]
    turns = cycle(solved(name), PLACES).turns
    assert [place["angle"] for place in found["places"]] == [turn.shown for turn in turns[::8]]
    assert all(place["paths"] > 10 and place["readings"] == 3 * len(solved(name).answers) for place in found["places"])


def test_the_first_paint_comes_within_a_second(files: Path) -> None:
    with chromium() as fresh:
        fresh.open(f"{(files / KINEMATICS).as_uri()}.html")
        assert fresh.wait("performance.getEntriesByName('first-contentful-paint')[0]?.startTime") < 1000


def test_keys_play_stop_and_leave_the_slider_its_own(files: Path, page: Page) -> None:
    page.open(f"{(files / KINEMATICS).as_uri()}.html")
    page.wait("player.ready")
    page.press("ArrowRight")
    page.press("ArrowRight")
    assert page.value("player.step") == 3
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


@pytest.mark.parametrize(("width", "height"), [(390, 844), (844, 390), (320, 640), (1280, 800), (1920, 1080)])
def test_nothing_sticks_out_of_the_window_and_fingers_can_hit_the_controls(width: int, height: int, files: Path, page: Page) -> None:
    page.open(f"{(files / FORCES).as_uri()}.html", width, height, touch=width < 900)
    page.wait("player.ready")
    for mode in ("steps", "turn"):
        page.value(f"player.setMode('{mode}'); 0")
        assert page.value("document.documentElement.scrollWidth") <= width
        small = page.value("all('footer button, #zoom button').filter(b => { const r = b.getBoundingClientRect();"
                           " return r.width < 36 || r.height < 36 || r.right > innerWidth || r.bottom > innerHeight; }).length")
        assert small == 0
        assert page.value("stage.size().h") > 0.2 * height


def test_a_figure_that_is_shown_fits_the_window(files: Path, page: Page) -> None:
    page.open(f"{(files / FORCES).as_uri()}.html", 390, 844, touch=True)
    page.wait("player.ready")
    for step in range(1, len(solved(FORCES).construction.steps) + 1):
        page.value(f"player.go({step}); player.frame(true); 0")
        out = page.value("figures.filter(f => !f.node.classList.contains('aside') && f.steps[0] <= player.step).filter(f => {"
                         " const b = stage.spots.get(f.key), c = stage.camera; return b.x < c.x || b.y < c.y || b.x + b.w > c.x + c.w || b.y + b.h > c.y + c.h; }).length")
        assert out == 0, step


def test_text_stands_out_from_its_ground(files: Path, page: Page) -> None:
    """WCAG: 4.5 to 1 for text, by day and by night."""
    script = """(() => {
      const light = (c) => { const [r, g, b] = c.match(/[\\d.]+/g).map((v) => { v /= 255; return v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
      const ground = (n) => { for (; n; n = n.parentElement) { const c = getComputedStyle(n).backgroundColor; if (!/, 0\\)|transparent/.test(c)) return c; } return "rgb(255,255,255)"; };
      return all("h1, h2, .words, li, button, summary, .note, td, th, output").filter((n) => n.offsetParent).map((n) => {
        const a = light(getComputedStyle(n).color), b = light(ground(n)); return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), n.outerHTML.slice(0, 60)];
      }).filter(([ratio]) => ratio < 4.5); })()"""
    for scheme in ("light", "dark"):
        page.open(f"{(files / KINEMATICS).as_uri()}.html")
        page.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        page.wait("player.ready")
        page.value("player.go(5); 0")
        assert page.value(script) == [], scheme

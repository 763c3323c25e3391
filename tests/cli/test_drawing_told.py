"""A drawing that is written tells whoever cannot see it what it is and what it shows."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner

from vecpoly.cli.app import app
from vecpoly.tagging.speech import spoken

SVG = "{http://www.w3.org/2000/svg}"


def told(folder: Path, *options: str) -> dict[str, str | None]:
    out = folder / "x.svg"
    done = CliRunner().invoke(app, ["draw", "3-9", "-o", str(out), *options])
    assert done.exit_code == 0, done.output
    root = ElementTree.fromstring(out.read_text(encoding="utf-8"))
    return {name: root.findtext(f"{SVG}{name}") for name in ("title", "desc")}


@pytest.mark.parametrize(("lang", "title"), [("zh", "摇块机构的速度与加速度"), ("en", None)])
def test_an_svg_of_a_figure_names_its_problem_and_its_vectors(lang: str, title: str | None, tmp_path: Path) -> None:
    found = told(tmp_path, "--figure", "velocity", "--lang", lang)
    assert found["title"] == title if title else found["title"]
    for symbol in ("v_B", "v_{C2C3}"):
        assert spoken(symbol, "zh" if lang == "zh" else "en") in (found["desc"] or "")


def test_an_svg_of_a_sheet_has_the_title_of_its_problem_alone(tmp_path: Path) -> None:
    assert told(tmp_path) == {"title": "摇块机构的速度与加速度", "desc": None}


def test_a_sheet_that_is_begun_shows_no_title_of_what_is_not_and_no_answers(tmp_path: Path) -> None:
    """After step 4 the acceleration polygon had its title and scale already, and the box told a_E."""
    shown = {}
    for step in ("4", "12"):
        out = tmp_path / f"{step}.svg"
        assert CliRunner().invoke(app, ["draw", "3-9", "-o", str(out), "--step", step]).exit_code == 0
        shown[step] = "".join(ElementTree.fromstring(out.read_text(encoding="utf-8")).itertext())
    assert "速度多边形" in shown["4"] and "加速度多边形" not in shown["4"]
    assert "加速度多边形" in shown["12"] and len(shown["4"]) < len(shown["12"])

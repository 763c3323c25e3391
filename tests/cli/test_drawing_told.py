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

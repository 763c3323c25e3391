"""Claims about the package: its Python surface, and what an installation away from the checkout can do."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from zipfile import ZipFile

import pytest

import vecpoly

ROOT = Path(__file__).resolve().parents[2]


def test_every_public_name_is_there() -> None:
    for name in vecpoly.__all__:
        assert callable(getattr(vecpoly, name))
    with pytest.raises(AttributeError, match="no attribute 'sovle'"):
        vecpoly.sovle


def test_importing_vecpoly_imports_nothing_else() -> None:
    code = "import sys, vecpoly; print([n for n in sys.modules if n.startswith(('vecpoly.', 'numpy', 'pydantic'))])"
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
    )


def test_the_version_is_that_of_the_distribution() -> None:
    assert vecpoly.__version__ == tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["version"]


def test_load_solve_report_in_one_line(tmp_path: Path) -> None:
    path = vecpoly.load("3-9").solve(by="exact").report(tmp_path / "out.pdf")
    assert path.read_bytes().startswith(b"%PDF")


def test_problem_and_solution_are_pictures_in_jupyter() -> None:
    problem = vecpoly.load("3-9")
    assert problem._repr_svg_().startswith("<svg") and problem.solve()._repr_svg_().startswith("<svg")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    words = [
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--no-deps",
        "--no-build-isolation",
        "--wheel-dir",
        str(folder),
        str(ROOT),
    ]
    subprocess.run([sys.executable, *words], check=True, capture_output=True, timeout=120)
    return next(folder.glob("*.whl"))


def test_the_wheel_holds_fonts_templates_problems_and_licences(wheel: Path) -> None:
    held = set(ZipFile(wheel).namelist())
    for folder, kind in (("problems", "*.yaml"), ("templates", "*.j2"), ("templates", "*.css"), ("templates", "*.js")):
        for path in (ROOT / folder).rglob(kind):
            assert f"vecpoly/_data/{path.relative_to(ROOT).as_posix()}" in held
    for path in (ROOT / "vecpoly").rglob("*"):
        if path.suffix in (".py", ".ttf", ".yaml", ".typed"):
            assert path.relative_to(ROOT).as_posix() in held
    assert {Path(name).name for name in held} >= {"LICENSE", "OFL.txt", "entry_points.txt"}


def test_an_installed_wheel_solves_and_reports_away_from_the_checkout(wheel: Path, tmp_path: Path) -> None:
    home = tmp_path / "site"
    ZipFile(wheel).extractall(home)  # all that there is to installing a wheel of pure Python
    env = {**os.environ, "PYTHONPATH": str(home)}

    def run(*words: str) -> str:
        done = subprocess.run(
            [sys.executable, *words], cwd=tmp_path.anchor, env=env, capture_output=True, check=True, timeout=120
        )
        return done.stdout.decode()

    solved = (
        "import vecpoly; from typer.testing import CliRunner; from vecpoly.cli import app; print(vecpoly.__file__);"
        "print(CliRunner().invoke(app, ['solve', '3-9']).stdout)"
    )
    where, *told = run("-X", "utf8", "-c", solved).splitlines()
    assert where.startswith(str(home)) and any("ω_3" in line for line in told)
    run("-m", "vecpoly", "report", "3-9", "-o", str(tmp_path / "x.pdf"))
    assert (tmp_path / "x.pdf").stat().st_size > 20_000


@pytest.mark.parametrize("name", ["README.md", "README.zh.md"])
def test_the_readme_file_gives_the_numbers_the_readme_prints(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    (problem,) = re.findall(r"```yaml\n(.*?)```", text, re.S)
    answers = vecpoly.loads(problem).solve().answers
    assert (
        f"| v_E | {answers['v_E'].reading.mm:.1f} mm | {answers['v_E'].drawn:.4g} m/s | "
        f"{answers['v_E'].exact:.5g} m/s |" in text
    )
    assert (
        f"| a_E | {answers['a_E'].reading.mm:.1f} mm | {answers['a_E'].drawn:.4g} m/s² | "
        f"{answers['a_E'].exact:.4g} m/s² |" in text
    )
    assert f"{-answers['omega_3'].drawn:.5g} rad/s ↻ | {-answers['omega_3'].exact:.5g} rad/s ↻" in text


@pytest.mark.parametrize("name", ["README.md", "README.zh.md", "CONTRIBUTING.md", "docs/architecture.md"])
def test_every_link_of_a_page_leads_somewhere(name: str) -> None:
    page = ROOT / name
    for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
        assert (page.parent / target).is_file(), target

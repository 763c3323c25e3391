"""Claims about other packages: an entry point adds a method or a device,
replaces none, and a broken one is told by name."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PLACE = ("vecpoly", "methods", "kinematics", "gears")  # where the page's example lies


def blocks(page: str, kind: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.S)


def absolute(text: str) -> str:
    """A method of the house as a file of another package."""
    return re.sub(
        r"^from (\.+)", lambda dots: f"from {'.'.join(PLACE[: len(PLACE) - len(dots[1]) + 1])}.", text, flags=re.M
    )


class Package:
    """A package installed in a folder: its modules and its entry points."""

    def __init__(self, home: Path) -> None:
        self.home = home

    def install(self, module: str, text: str, group: str) -> None:
        about = self.home / "others-1.0.dist-info"
        about.mkdir(exist_ok=True)
        (about / "METADATA").write_text("Metadata-Version: 2.1\nName: others\nVersion: 1.0\n", encoding="utf-8")
        (about / "entry_points.txt").write_text(f"[{group}]\nmore = {module}\n", encoding="utf-8")
        (self.home / f"{module}.py").write_text(text, encoding="utf-8")

    def vecpoly(self, *words: str) -> subprocess.CompletedProcess[str]:
        env = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(self.home))), "PYTHONUTF8": "1"}
        return subprocess.run(
            [sys.executable, "-m", "vecpoly", *words], env=env, capture_output=True, encoding="utf-8", check=False
        )


@pytest.fixture
def package(tmp_path: Path) -> Package:
    return Package(tmp_path)


def answers(done: subprocess.CompletedProcess[str]) -> dict[str, dict[str, float]]:
    assert done.returncode == 0, done.stderr
    found: dict[str, dict[str, float]] = json.loads(done.stdout)["answers"]
    return found


def test_another_package_adds_a_method(package: Package) -> None:
    problem = package.home / "inclined-rack.yaml"
    problem.write_text(blocks("docs/architecture.md", "yaml")[0], encoding="utf-8")
    without = package.vecpoly("solve", str(problem))
    assert without.returncode == 2 and "RGP" in without.stderr
    package.install("racks", absolute(blocks("docs/architecture.md", "python")[0]), "vecpoly.methods")
    found = answers(package.vecpoly("solve", str(problem), "--hand", "exact", "--json", "-"))
    assert found["v_D"]["drawn"] == pytest.approx(found["v_D"]["exact"], rel=1e-9)
    assert "RGP" in package.vecpoly("list", "methods").stdout


@pytest.fixture
def levers(package: Package) -> Package:
    package.install("levers", blocks("CONTRIBUTING.md", "python")[0], "vecpoly.devices")
    (package.home / "lever.yaml").write_text(blocks("CONTRIBUTING.md", "yaml")[0], encoding="utf-8")
    return package


def test_another_package_adds_a_device(levers: Package) -> None:
    found = answers(levers.vecpoly("solve", str(levers.home / "lever.yaml"), "--json", "-"))
    assert found["F"]["drawn"] == pytest.approx(40.0) and found["F"]["exact"] == pytest.approx(40.0)
    assert "lever" in levers.vecpoly("schema").stdout


def test_a_device_of_another_package_is_drawn_and_reported(levers: Package) -> None:
    picture, report = levers.home / "lever.svg", levers.home / "lever.pdf"
    for words in (
        ("draw", "lever.yaml", "--figure", "mechanism", "-o", picture),
        ("report", "lever.yaml", "-o", report),
    ):
        done = levers.vecpoly(*(str(levers.home / word) if word == "lever.yaml" else str(word) for word in words))
        assert done.returncode == 0, done.stderr
    assert picture.read_text(encoding="utf-8").startswith("<svg") and report.read_bytes().startswith(b"%PDF")


def test_a_package_that_cannot_be_loaded_is_told_by_name_in_both_languages(package: Package) -> None:
    package.install("broken", 'raise RuntimeError("out of paper")', "vecpoly.devices")
    (package.home / "x.yaml").write_text("id: x\ntitle: x\ndevice: lever\ndata: {}\n", encoding="utf-8")
    for lang, word in (
        ("en", "the plug-in others (broken) cannot be loaded: RuntimeError: out of paper"),
        ("zh", "插件 others（broken）不能载入"),
    ):
        done = package.vecpoly("solve", str(package.home / "x.yaml"), "--lang", lang)
        assert done.returncode == 2 and word in done.stderr and "Traceback" not in done.stderr


def test_a_broken_package_does_not_hinder_what_the_house_has(package: Package) -> None:
    package.install("broken", 'raise RuntimeError("out of paper")', "vecpoly.devices")
    assert answers(package.vecpoly("solve", "5-1", "--json", "-"))["F"]["drawn"] > 0


def test_two_devices_of_one_name_are_refused(package: Package) -> None:
    package.install(
        "again",
        "from vecpoly.devices.base import Device\n\nclass Mine(Device):\n    kind = 'incline'\n",
        "vecpoly.devices",
    )
    done = package.vecpoly("schema")
    assert done.returncode == 2 and "two devices are named 'incline'" in done.stderr

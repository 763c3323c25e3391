"""Claims about other packages: an entry point adds a method or a device,
replaces none, and a broken one is told by name."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

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


TELL = """
import json, sys
from typer.testing import CliRunner
from vecpoly.cli import app
done = [CliRunner().invoke(app, words.split()) for words in sys.argv[1:]]
print(json.dumps([(one.exit_code, one.stdout, one.stderr) for one in done]))
"""


class Done(NamedTuple):
    """How a command ended, and what it said."""

    returncode: int
    stdout: str
    stderr: str


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

    def vecpoly(self, *commands: str) -> list[Done]:
        """What comes of these commands, one after the other, where the package is installed."""
        env = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(self.home))), "PYTHONUTF8": "1"}
        command = [sys.executable, "-c", TELL, *commands]
        told = subprocess.run(command, env=env, cwd=self.home, capture_output=True, encoding="utf-8", check=True)
        return [Done(*one) for one in json.loads(told.stdout)]


@pytest.fixture
def package(tmp_path: Path) -> Package:
    return Package(tmp_path)


def answers(done: Done) -> dict[str, dict[str, float]]:
    assert done.returncode == 0, done.stderr
    found: dict[str, dict[str, float]] = json.loads(done.stdout)["answers"]
    return found


def test_another_package_adds_a_method(package: Package) -> None:
    """Without it the problem is refused: test_architecture.py."""
    (package.home / "rack.yaml").write_text(blocks("docs/architecture.md", "yaml")[0], encoding="utf-8")
    package.install("racks", absolute(blocks("docs/architecture.md", "python")[0]), "vecpoly.methods")
    solved, listed = package.vecpoly("solve rack.yaml --hand exact --json -", "list methods")
    assert answers(solved)["v_D"]["drawn"] == pytest.approx(answers(solved)["v_D"]["exact"], rel=1e-9)
    assert "RGP" in listed.stdout


def test_another_package_adds_a_device_that_is_solved_drawn_and_reported(package: Package) -> None:
    package.install("levers", blocks("CONTRIBUTING.md", "python")[0], "vecpoly.devices")
    (package.home / "lever.yaml").write_text(blocks("CONTRIBUTING.md", "yaml")[0], encoding="utf-8")
    solved, schema, *others = package.vecpoly(
        "solve lever.yaml --json -",
        "schema",
        "draw lever.yaml --figure mechanism -o lever.svg",
        "report lever.yaml -o lever.pdf",
    )
    force = answers(solved)["F"]
    assert force["drawn"] == pytest.approx(40.0) and force["exact"] == pytest.approx(40.0)
    assert "lever" in schema.stdout
    assert [done.returncode for done in others] == [0, 0], others
    assert (package.home / "lever.svg").read_text(encoding="utf-8").startswith("<svg")
    assert (package.home / "lever.pdf").read_bytes().startswith(b"%PDF")


def test_a_package_that_cannot_be_loaded_is_told_by_name_and_hinders_nothing_else(package: Package) -> None:
    package.install("broken", 'raise RuntimeError("out of paper")', "vecpoly.devices")
    (package.home / "x.yaml").write_text("id: x\ntitle: x\ndevice: lever\ndata: {}\n", encoding="utf-8")
    en, zh, own = package.vecpoly("solve x.yaml --lang en", "solve x.yaml --lang zh", "solve 5-1 --json -")
    assert "the plug-in others (broken) cannot be loaded: RuntimeError: out of paper" in en.stderr
    assert "插件 others（broken）不能载入" in zh.stderr
    assert all(done.returncode == 2 and "Traceback" not in done.stderr for done in (en, zh))
    assert answers(own)["F"]["drawn"] > 0


def test_two_devices_of_one_name_are_refused(package: Package) -> None:
    package.install(
        "again",
        "from vecpoly.devices.base import Device\n\nclass Mine(Device):\n    kind = 'incline'\n",
        "vecpoly.devices",
    )
    (done,) = package.vecpoly("schema")
    assert done.returncode == 2 and "two devices are named 'incline'" in done.stderr

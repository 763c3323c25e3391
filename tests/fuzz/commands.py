"""Command lines by lot, drawn from what the commands say of themselves, and what becomes of them in a folder."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import shlex
import shutil
import tempfile
import traceback
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

import numpy as np
import typer
from typer.testing import CliRunner, Result

from vecpoly.cli import app
from vecpoly.cli.errors import DISAGREES, REFUSED, SUSPECT, UNSOLVABLE
from vecpoly.problem.library import find, library

from .outcome import End, Outcome

LEFT_OUT = ("demo", "search", "design")  # minutes each
GIVEN = {
    "given.yaml": None,  # a copy of a problem
    "broken.yaml": "id: x\nlinks: {1: {AB: 100 mm}\n",
    "列表.csv": "学号,姓名\n2023001,张三\n2023002,李四\n",
    "table.csv": "phi,omega_3\n0,1.2\n30,1.3\n",
    "hw.yaml": "id: hw\ntitle: 作业\nproblems: [3-9]\n",
    "空.csv": "",
}
_STRANGE = (
    "", " ", "-", "--", ".", "..", "folder", "没有", "３－９", "x" * 300, "$(x)", "a b", "{}", "[1", "nan", "∞", "9-99",
)  # fmt: skip
_OUTPUTS = (
    "out.pdf", "out.png", "x.svg", "x.dxf", "x.ggb", "x.html", "x.csv", "x.xlsx", "x.json", "x.txt", "-", "folder",
    "new/", "new/a/x.pdf", "given.yaml", "列表.csv", "图 1.pdf", "x.pdf.", "x", "out.PDF",
)  # fmt: skip
_ANSWERS = (
    "v_C=0.49", "ω5=4.72", "omega_3 = 2 cw", "v_B", "AB=120 mm", "x=1", "=", "v_C=", "φ=30°", "a_C=1e400",
    "v_C=0.49 m/s 30°",
)  # fmt: skip
_WORDS = (
    "velocity", "acceleration", "force", "mechanism", "v_C", "3-9", "phi=60 deg", "AB=80 mm", "A", "h=a", "1/2",
)  # fmt: skip
_TAME = {
    "report": ("out.pdf", "folder", "-"), "draw": ("out.png", "x.svg", "x.dxf", "图 1.pdf", "-"), "export": ("x.ggb",),
    "play": ("x.html",), "cycle": ("x.csv", "x.xlsx", "x.json", "x.pdf"), "class": ("new",), "new": ("x.yaml",),
}  # fmt: skip
_NUMBERS = ("-1", "0", "1", "2", "3", "7", "12", "1e3", "99999999999", "1.5", "x", "")
_SOURCE = find("3-9") or Path()
TAME = 0.6  # the share of command lines that somebody may mean
_ENDS = {0, DISAGREES, REFUSED, SUSPECT, UNSOLVABLE}


def commands(rng: np.random.Generator, count: int) -> Iterator[str]:
    """So many command lines, each as a shell would read it."""
    known = {name: one for name, one in typer.main.get_command(app).commands.items() if name not in LEFT_OUT}  # type: ignore[attr-defined]
    for _ in range(count):
        name = str(rng.choice(sorted(known)))
        said = _tamely if rng.random() < TAME else _said
        yield shlex.join([name, *(word for one in known[name].params for word in said(rng, one, name))])


def _tamely(rng: np.random.Generator, parameter: Any, command: str) -> list[str]:
    """As somebody says it who knows the command: one problem of the library, and options with values of their kind."""
    kind = parameter.type_descriptor.annotation
    if type(parameter).__name__ == "TyperArgument":
        return ["hw.yaml" if command == "class" else _of(rng, [one.id for one in library()])]
    option = parameter.opts[-1]
    if option in ("--output", "--roster") and rng.random() < 0.8:
        return [option, "列表.csv" if option == "--roster" else _of(rng, _TAME.get(command, ("-",)))]
    if rng.random() > 0.2 or option == "--help" or parameter.metavar:
        return []
    if kind is bool:
        return [option]
    if get_origin(kind) is Literal:
        return [option, _of(rng, [str(one) for one in get_args(kind)])]
    return [option, _of(rng, ("1", "2", "3"))] if kind in (int, float) else []


def _said(rng: np.random.Generator, parameter: Any, command: str) -> list[str]:
    """An argument, as a rule; an option, now and then: of its kind or not."""
    kind = parameter.type_descriptor.annotation
    if type(parameter).__name__ == "TyperArgument":
        return [_name(rng) for _ in range(int(rng.choice([1, 1, 1, 2, 0])))] if rng.random() < 0.97 else []
    if rng.random() > (0.6 if "--output" in parameter.opts else 0.2) or "--help" in parameter.opts:
        return []
    option = _of(rng, parameter.opts)
    if kind is bool:
        return [option]
    return [option, _value(rng, kind, parameter)]


def _value(rng: np.random.Generator, kind: Any, parameter: Any) -> str:
    """A value of an option: mostly of its kind."""
    if rng.random() < 0.05:
        return _of(rng, _STRANGE)
    if get_origin(kind) is Literal:
        return _of(rng, [str(one) for one in get_args(kind)])
    if parameter.name in ("processes", "jobs"):
        return _of(rng, ("1", "2", "0", "-1"))
    if kind in (int, float):
        return _of(rng, _NUMBERS)
    if kind is Path:
        return _of(rng, (*_OUTPUTS, *GIVEN))
    return _of(rng, _WORDS)


def _name(rng: np.random.Generator) -> str:
    """A problem, a file, an answer, or something strange."""
    lot = rng.random()
    if lot < 0.6:
        return _of(rng, [one.id for one in library()])
    if lot < 0.8:
        return _of(rng, (*GIVEN, "folder", "没有.yaml"))
    return _of(rng, _ANSWERS if lot < 0.92 else _STRANGE)


def _of(rng: np.random.Generator, pool: Sequence[str]) -> str:
    return pool[int(rng.integers(len(pool)))]


def of_command(line: str) -> Outcome:
    """Run it in a folder of its own: a traceback, an unknown exit code, a refusal without a word, a file that was given
    and is changed, an empty or a temporary file left behind, all count as broken."""
    with tempfile.TemporaryDirectory() as folder:
        _furnish(Path(folder))
        before = printed(Path(folder))
        with contextlib.chdir(folder):
            os.environ.pop("VECPOLY_LANG", None)
            try:
                result = CliRunner().invoke(app, shlex.split(line), prog_name="vecpoly")
            except BaseException as error:  # what the runner itself cannot hold
                return Outcome(End.TRACEBACK, f"{type(error).__name__}: {error}")
        wrong = wrong_end(result) or spoilt(Path(folder), before, result.exit_code) or _json(line, result)
    if wrong:
        return Outcome(End.TRACEBACK, wrong)
    return Outcome(End.SOLVED if result.exit_code in (0, DISAGREES) else End.REFUSED)


def _furnish(folder: Path) -> None:
    (folder / "folder").mkdir()
    for name, text in GIVEN.items():
        if text is None:
            shutil.copy(_SOURCE, folder / name)
        else:
            (folder / name).write_text(text, encoding="utf-8")


def printed(folder: Path) -> dict[str, str]:
    """A print of each file's bytes."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*")
        if path.is_file()
    }


def wrong_end(result: Result) -> str:
    """A traceback, an exit code that is none, a refusal without a word."""
    error = result.exception
    if error is not None and not isinstance(error, SystemExit):
        last = traceback.extract_tb(error.__traceback__)[-1]
        return f"{type(error).__name__}: {str(error)[:80]} | {Path(last.filename).name}:{last.lineno}"
    if "Traceback (most" in result.output:
        return "a traceback is printed"
    if result.exit_code not in _ENDS:
        return f"exit code {result.exit_code}"
    if result.exit_code and not result.output.strip():
        return f"exit code {result.exit_code} without a word"
    return ""


def spoilt(folder: Path, before: dict[str, str], code: int) -> str:
    """What became of the files: those given are as they were, and what is new is whole."""
    after = printed(folder)
    for name, print_ in before.items():
        if after.get(name) != print_ and code:
            end = "gone" if name not in after else "changed"
            return f"{name} was given, is {end}, and the exit code is {code}"
        if after.get(name) != print_ and name.endswith(".yaml"):
            return f"{name} was overwritten"
    new = [name for name in after if name not in before]
    if empty := [name for name in new if not (folder / name).stat().st_size]:
        return f"{empty[0]} is empty"
    if odd := [name for name in new if Path(name).name.startswith((".", "tmp")) or name.endswith((".tmp", ".part"))]:
        return f"{odd[0]} was left behind"
    return ""


def _json(line: str, result: Result) -> str:
    """JSON to standard output is nothing but that."""
    words = shlex.split(line)
    asked = any(one == "--json" and other == "-" for one, other in pairwise(words))
    if not asked or result.exit_code not in (0, SUSPECT) or "-h" in words:
        return ""
    try:
        json.loads(result.stdout)
    except ValueError as error:
        return f"no JSON: {error}"
    return ""

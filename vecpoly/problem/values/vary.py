"""problem.vary(AB="120 mm", phi="30 deg"): the same problem with other values, built anew without reading any YAML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any

from ...errors import ArgumentError
from ...foundation.slotted import replace
from ...words import Words
from ..build import build
from ..meaning import alike, at, meant_by, said
from ..problem import Problem
from ..schema.faults import Place
from ..text.numbers import Quantity, as_pair, as_text
from ..text.source import Tree
from .parameters import named
from .slot import Slot
from .written import Written, text_of, thawed, written_of

Point = complex | Sequence[Quantity]
_BUILT = ("subject", "loads", "given")  # what follows from the values, and can be no other than they say
_READ = ("path", "read", "text", "tables", "written")  # where it comes from


def vary(problem: Problem, changes: Mapping[str, Quantity | Point]) -> Problem:
    """The problem with these values; raises UnknownNameError, ArgumentError; ProblemFileError as a file would."""
    written = _own(problem)
    tree, touched = written.tree(), dict[tuple[Any, ...], str]()
    known = named(tree.data)
    for name, value in changes.items():
        for slot in (found := meant_by(name, tree.data, known)):
            _once(slot, name, touched)
            _put(tree, slot, name, value)
        if any(slot.span or slot.pair for slot in found):  # what stands behind it in the same text has moved
            known = named(tree.data)
    anew = _built(written_of(tree), problem.path)
    text = text_of(tree.data) if anew.written != written else problem.text
    old = _built(written, problem.path)
    kept = {key: getattr(problem, key) for key in _others() if getattr(problem, key) != getattr(old, key)}
    return replace(anew, text=text, read=problem.read, tables=problem.tables, **kept)


def parameters(problem: Problem) -> dict[str, str]:
    """The short names by which values may be varied, with what is written: {'AB': '30 mm', 'phi': '60 deg', ...}."""
    data = _own(problem).tree().data
    return {
        name: said(data, found[0])
        for name, found in named(data).items()
        if name != found[0].full and alike(data, found)
    }


def _own(problem: Problem) -> Written:
    """What the problem says; raises ArgumentError where it is no longer what its values say."""
    if problem.written is None:
        raise ArgumentError(
            Words(
                f"题目 {problem.id} 不是由文件或数据读入的，没有可改的值；请用 vecpoly.problem(...) 或 load 建立",
                f"problem {problem.id} was not read from a file or from data and has no values to vary; "
                "make it by vecpoly.problem(...) or load",
            ),
            code="no-values",
        )
    old = _built(problem.written, problem.path)
    if any(getattr(problem, key) != getattr(old, key) for key in _BUILT):
        raise ArgumentError(
            Words(
                f"题目 {problem.id} 的机构或载荷已另行更换，与其数据不再一致；请先 vary 再更换",
                f"the mechanism or the loads of problem {problem.id} were replaced "
                "and are no longer what its values say; vary first, replace then",
            ),
            code="replaced",
        )
    return problem.written


@lru_cache(maxsize=64)
def _built(written: Written, path: FilePath | None) -> Problem:
    """The problem that these values make, without its tables, which were found when it was loaded."""
    tree = written.tree()
    tree.data.pop("tables", None)
    made = build(tree, path, written)
    return made if made.written is written else replace(made, written=written)


def _others() -> list[str]:
    return [one.name for one in fields(Problem) if one.name not in (*_BUILT, *_READ, "warnings")]


def _once(slot: Slot, name: str, touched: dict[tuple[Any, ...], str]) -> None:
    """Raise ArgumentError where two names are given for one quantity."""
    here = (*slot.path, slot.names) if slot.span else slot.path
    for there, other in touched.items():
        if other != name and (there[: len(here)] == here or here[: len(there)] == there):
            raise ArgumentError(
                Words(
                    f"{other} 与 {name} 是同一个量，只能给出一个",
                    f"{other} and {name} are one quantity; give one of them",
                ),
                code="contradiction",
            )
    touched[here] = name


def _put(tree: Tree, slot: Slot, name: str, value: Quantity | Point) -> None:
    """Write the value at its place, which is told by this name from now on."""
    new = as_pair(name, value) if slot.pair else as_text(name, value, slot.dim)
    if slot.span and " from " not in str(new):
        old, new = at(tree.data, slot.path), _in_unit(name, str(new), slot.unit)
        new = f"{old[: slot.span[0]]}{new}{old[slot.span[1] :]}"
    if new != at(tree.data, slot.path):
        at(tree.data, slot.path[:-1])[slot.path[-1]] = new
        tree.places[slot.path] = Place(f"vary({name})")


def _in_unit(name: str, text: str, unit: str) -> str:
    """The number alone of one of two in brackets, with their unit behind; raises ArgumentError for another unit."""
    if not unit:
        return text
    if not text.endswith(unit):
        raise ArgumentError(
            Words(
                f"{name} 写在括号内，单位 {unit} 在括号后；请用 {unit} 给出，而不是“{text}”",
                f"{name} stands in brackets with the unit {unit} behind them; give it in {unit}, not '{text}'",
            ),
            code="wrong-unit",
        )
    return text.removesuffix(unit).strip()


def data_of(problem: Problem) -> dict[str, Any]:
    """The values of the problem as a plain dictionary of texts, which `vecpoly.problem` takes."""
    plain: dict[str, Any] = thawed(_own(problem).data)
    return plain

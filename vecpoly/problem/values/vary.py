"""problem.vary(AB="120 mm", phi="30 deg"): the same problem with other values, built anew without reading any YAML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any

from ...errors import ArgumentError, FaultError, UnknownNameError
from ...units.reading import Dim, read
from ...words import Words
from ..build import build
from ..problem import Problem
from ..schema.faults import Place, meant
from ..text.numbers import Quantity, as_pair, as_text
from ..text.source import Tree, Value
from .parameters import Slot, named, other_way
from .written import Written, text_of, thawed, written_of

Point = complex | Sequence[Quantity]
_BUILT = ("subject", "loads", "given")  # what follows from the values, and can be no other than they say
_READ = ("path", "read", "text", "tables", "written")  # where it comes from


def vary(problem: Problem, changes: Mapping[str, Quantity | Point]) -> Problem:
    """The problem with these values; raises UnknownNameError, ArgumentError; ProblemFileError as a file would."""
    written = _own(problem)
    tree, touched = written.tree(), dict[tuple[Any, ...], str]()
    for name, value in changes.items():
        for slot in meant_by(name, tree.data):
            _once(slot, name, touched)
            _put(tree, slot, name, value)
    anew = _built(written_of(tree), problem.path)
    text = text_of(tree.data) if anew.written != written else problem.text
    old = _built(written, problem.path)
    kept = {key: getattr(problem, key) for key in _others() if getattr(problem, key) != getattr(old, key)}
    return replace(anew, text=text, read=problem.read, tables=problem.tables, **kept)


def parameters(problem: Problem) -> dict[str, str]:
    """The short names by which values may be varied, with what is written: {'AB': '30 mm', 'phi': '60 deg', ...}."""
    data = _own(problem).tree().data
    return {
        name: _said(data, found[0])
        for name, found in named(data).items()
        if name != found[0].full and _alike(data, found)
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
    return replace(build(tree, path), written=written)


def _others() -> list[str]:
    return [one.name for one in fields(Problem) if one.name not in (*_BUILT, *_READ, "warnings")]


def meant_by(name: str, data: Mapping[str, Value]) -> tuple[Slot, ...]:
    """The quantities of this name; raises UnknownNameError where there is none, or several that differ."""
    known = named(data)
    found = known.get(name) or known.get(other_way(name)) or ()
    if not found:
        short = [key for key, of in known.items() if key != of[0].full]
        raise UnknownNameError(
            Words(f"本题没有可改的量“{name}”", f"nothing that is given is called '{name}'")
            + meant(name, short)
            + _frame(name, data),
            code="unknown-name",
        )
    if not _alike(data, found):
        zh, en = (comma.join(f"{slot.full} = {_said(data, slot)}" for slot in found) for comma in ("、", ", "))
        raise UnknownNameError(
            Words(
                f'“{name}”指几个不同的量：{zh}；请写全名，如 vary(**{{"{found[0].full}": ...}})',
                f"'{name}' means several that differ: {en}; "
                f'give the full name, e.g. vary(**{{"{found[0].full}": ...}})',
            ),
            code="ambiguous-name",
        )
    return found


def _frame(name: str, data: Mapping[str, Value]) -> Words:
    """That the distance of two fixed points is no value of its own."""
    first, second = name[:1], name[1:]
    frame = data.get("frame") or {}
    if first in frame and second in frame:
        return Words(
            f"；{first}、{second} 是机架上的点，请改其坐标 x_{second}、y_{second} 或 {second}=(x, y)",
            f"; {first} and {second} are points of the frame: vary x_{second} and y_{second}, or {second}=(x, y)",
        )
    return Words.same("")


def _said(data: Mapping[str, Value], slot: Slot) -> str:
    value = _at(data, slot.path)
    text = ", ".join(map(str, value)) if isinstance(value, list) else str(value)
    return text[slice(*slot.span)] if slot.span else text


def _alike(data: Mapping[str, Value], found: Sequence[Slot]) -> bool:
    """Whether all say the same, in whatever units."""
    return len({_amount(_said(data, slot), slot.dim) for slot in found}) == 1


def _amount(text: str, dim: Dim | None) -> float | str:
    try:
        return float(text) if dim is None else read(text, dim).si
    except (FaultError, ValueError):
        return text


def _at(data: Any, path: Sequence[str | int]) -> Any:
    for step in path:
        data = data[step]
    return data


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
        old = _at(tree.data, slot.path)
        new = f"{old[: slot.span[0]]}{new}{old[slot.span[1] :]}"
    if new != _at(tree.data, slot.path):
        _at(tree.data, slot.path[:-1])[slot.path[-1]] = new
        tree.places[slot.path] = Place(f"vary({name})")


def data_of(problem: Problem) -> dict[str, Any]:
    """The values of the problem as a plain dictionary of texts, which `vecpoly.problem` takes."""
    plain: dict[str, Any] = thawed(_own(problem).data)
    return plain

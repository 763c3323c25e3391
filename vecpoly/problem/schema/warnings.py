"""What is accepted but hardly meant: `phi: 75 rad`, a coefficient of friction above 1; what changes nothing: a question
that is put twice, a gate of no variants. Told, with its place, and not refused."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, tan

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...limits import ROUGH, UNSURE_ANGLE
from ...units.reading import Dim, read
from ...words import Words
from ..text.source import PROSE, Tree, Value
from .faults import Path, dotted

_RADIANS = pattern(r"(?<![\w.])[-+−]?(\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*(?:rad|弧度)(?![\w/*^·²])")
_COEFFICIENT = pattern(r"f\d*|f_\w+")


def warnings_of(tree: Tree) -> tuple[Words, ...]:
    """Everything in the file that looks like a slip, in its order."""
    slips = ((path, said) for path, text in _scalars(tree.data, ()) for said in _slips(path, text))
    return tuple(_placed(tree, path, said) for path, said in (*slips, *_needless(tree)))


def _needless(tree: Tree) -> Iterator[tuple[Path, Words]]:
    """What might as well not stand there."""
    find = tree.data.get("find")
    for i, one in enumerate(find if isinstance(find, list) else ()):
        if isinstance(find, list) and isinstance(one, str) and one in find[:i]:
            said = Words(f"{one} 问了两次；可以删去其一", f"{one} is asked twice; one may be left out")
            yield ("find", i), said
    if tree.data.get("gate") and not tree.data.get("vary"):
        said = Words(
            "没有 vary，数据不因人而异，gate 不起作用；可以删去",
            "without 'vary' there are no variants, and the gate decides nothing; it may be left out",
        )
        yield ("gate",), said


def _scalars(value: Value, path: Path) -> Iterator[tuple[Path, str]]:
    """Every value that is not a sentence, with its path."""
    match value:
        case dict():
            for key, item in value.items():
                if key not in PROSE and key != "title":
                    yield from _scalars(item, (*path, key))
        case list():
            for i, item in enumerate(value):
                yield from _scalars(item, (*path, i))
        case str():
            yield path, value


def _slips(path: Path, text: str) -> Iterator[Words]:
    for m in _RADIANS.finditer(text):
        if float(m[1]) > UNSURE_ANGLE:
            turns = float(m[1]) / (2 * pi)
            yield Words(
                f"{m[0].strip()} 等于 {turns:.3g} 整圈；若指的是度，请写 {m[1]} deg",
                f"{m[0].strip()} is {turns:.3g} whole turns; if degrees are meant, write {m[1]} deg",
            )
    if (f := _friction(path, text)) > ROUGH:
        yield Words(
            f"摩擦系数 {f:.3g} 大于 {ROUGH:g}，机械中几乎没有这样的副；请核对",
            f"a coefficient of friction of {f:.3g} is above {ROUGH:g}, which hardly any joint of a "
            "machine has; check it",
        )


def _friction(path: Path, text: str) -> float:
    """The coefficient that this value stands for; 0 where it is none: among the data of a task φ is no angle of
    friction, but one that somebody turns by."""
    try:
        if path[0] in ("friction", "data") and _COEFFICIENT.fullmatch(str(path[-1])):
            return float(text)
        angle = read(text, Dim.ANGLE).si if path[0] == "friction" and path[-1] == "phi" else 0.0
    except (ValueError, FaultError):
        return 0.0
    return tan(angle) if 0 < angle < pi / 2 else 0.0


def _placed(tree: Tree, path: Path, said: Words) -> Words:
    place = next((tree.places[path[:n]] for n in range(len(path), 0, -1) if path[:n] in tree.places), None)
    zh, en = (f"第 {place.line} 行，", f"line {place.line}, ") if place and place.line else ("", "")
    return Words(f"{zh}{dotted(path)}：{said.zh}", f"{en}{dotted(path)}: {said.en}")

"""What the terminal tells of a whole turn: facts, extremes, paths."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, pi
from typing import TYPE_CHECKING

import typer

from ..names import written_unit
from ..words import Words, bare
from .options import Lang
from .terminal import add, show, table
from .wording import number

if TYPE_CHECKING:
    from ..cycle import Cycle
    from ..cycle.extremes import Extremes, Spot
    from ..problem.problem import Problem
_COLUMNS = {
    "zh": ("量", "单位", "最大", "位置", "最小", "位置"),
    "en": ("symbol", "unit", "greatest", "at", "least", "at"),
}


def print_turn(turn: Cycle, problem: Problem, keys: tuple[str, ...], lang: Lang) -> None:
    """Facts in sentences, extremes in a table, the paths of the points."""
    from ..cycle import Shape, facts, force_sentences, path, path_sentences, sentences

    typer.echo(f"{problem.id}  {bare(problem.title.of(lang))}\n")
    for words in _zero(turn):
        typer.echo(f"  {_plain(words.of(lang))}")
    for words in (*sentences(turn, facts(turn)), *force_sentences(turn)):
        typer.echo(f"  {_plain(words.of(lang))}")
    made = table("", [(name, "right" if i > 1 else "left") for i, name in enumerate(_COLUMNS[lang])])
    for key in keys or tuple(column.key for column in turn.columns):
        add(made, _row(turn, key))
    typer.echo("")
    show(made)
    for letter in [column.key[2:] for column in turn.columns if column.key.startswith("p_") and not keys]:
        found = path(turn, letter)
        if found.shape is Shape.CURVE:
            told = (_plain(words.of(lang)) for words in path_sentences(turn, found))
            typer.echo("  " + ("" if lang == "zh" else " ").join(told))


def _zero(turn: Cycle) -> Iterator[Words]:
    """From where the drive's angle counts, where the problem tells it otherwise than from the x axis."""
    from ..cycle.counted import counted_from

    told = counted_from(turn.mech)
    if told.zh:
        symbol = turn.drive.symbol
        yield Words(
            f"${symbol}$ 按题目量取{told.zh}；其余各角由 $x$ 轴量起。",
            f"${symbol}$ counts as the problem tells it{told.en}, all other angles from the $x$ axis.",
        )


def _row(turn: Cycle, key: str) -> tuple[str, ...]:
    from ..check.precision import NOTHING
    from ..cycle import extremes
    from ..cycle.curve import Curve
    from ..cycle.facts.transmission_range import transmission

    found, info = extremes(turn, key), turn.info(key)
    acute = transmission(turn, key) if key.startswith("gamma_") else None
    zero = info.factor * NOTHING * Curve.of(turn, key).size
    cells: list[str] = []
    for spot in (acute.greatest, acute.least) if acute else (found.highest, found.lowest):
        cells += ["—", "—"] if spot is None else [_value(info.told(spot.value), zero), _place(turn, spot, found)]
    size = f"|{bare(info.symbol)}|" if info.is_vector else bare(info.symbol)
    return size, written_unit(info.shown_unit), *cells


def _place(turn: Cycle, spot: Spot, found: Extremes) -> str:
    """Where the drive stands then; nothing of what does not change."""
    if found.is_constant:
        return "—"
    from ..check.precision import NOTHING
    from ..cycle.facts.rests import stood

    drive, whole = turn.drive, pi if turn.drive.unit == "rad" else turn.mech.scale
    unit = written_unit("deg" if drive.unit == "rad" else " mm")
    if (stretch := stood(turn, found, spot)) is not None:
        return " … ".join(number(drive.told(phi), 6) + unit for phi in stretch)
    return number(drive.told(spot.phi), 7, drive.factor * NOTHING * whole) + unit


def _value(value: float, zero: float) -> str:
    return number(value, 7, zero) if isfinite(value) else "∞" if value > 0 else "−∞"


def _plain(text: str) -> str:
    return written_unit(bare(text))

"""From the cells of a sheet to positions of the drive and columns in SI;
units that are not written are found by fit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

import numpy as np

from ... import oracle
from ...cycle.facts.transmission import folded
from ...errors import TableError
from ...foundation.slotted import replace
from ...mechanism.model import Drive, Mechanism
from ...oracle import Motion
from ...oracle.run import wrapped
from ...problem.problem import Problem
from ...words import Words
from .header import Heading, Headings, known, read_header
from .numbering import NEAR, renumbered
from .sheet import Sheet, last_unit
from .target import Reals, Target
from .unwritten import DEG, MM, RAD, M, fitting, guessed, unit_by_size
from .weigh import Column

_STEPS = (15.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.1)  # deg


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Table:
    """A table in SI: the drive's positions (rad or m) as the oracle counts them,
    as printed, the columns, and what was found out."""

    name: str
    positions: Reals
    printed: Reals  # as a reader counts them: degrees, or mm
    columns: tuple[Column, ...]
    notes: tuple[Words, ...]
    left_out: tuple[str, ...]
    slide: bool = False  # whether the drive slides


def read_table(sheet: Sheet, problem: Problem, said: Mapping[str, str]) -> Table:
    """The table of this sheet; raises TableError for whatever cannot be read or belongs to no such mechanism."""
    mech = problem.mechanism
    head = read_header(sheet, mech, said, problem.loads)
    notes: list[Words] = []
    drive = _drive(sheet, head.drive, mech.drive, mech.scale, notes)
    shown = drive * 1e3 if mech.drive.slide else np.degrees(drive)
    positions = drive if mech.drive.slide else drive + _lead(problem)
    positions = _within(positions, _halves(sheet, head.drive) * (head.drive.unit or DEG).factor, mech)
    motion = oracle.solve(mech, positions, strict=False)
    head = _numbered(sheet, head, mech, motion, notes)
    columns = []
    for heading in head.columns:
        known(sheet, heading, mech, motion)
        columns.append(_column(sheet, heading, motion, notes))
    return Table(
        name=sheet.name,
        positions=positions,
        printed=shown,
        columns=tuple(columns),
        notes=tuple(notes),
        left_out=head.left_out,
        slide=mech.drive.slide,
    )


def _within(positions: Reals, half: Reals, mech: Mechanism) -> Reals:
    """The positions, those at an end of the drive's range put back inside by
    what the last digit has rounded them out of it."""
    spans, turn = np.array(oracle.spans(mech)), 0.0 if mech.drive.slide else 2 * pi
    if turn and (spans[:, 1] - spans[:, 0] >= turn * (1 - 1e-12)).any():
        return positions
    full = turn * np.floor((positions - spans[0, 0]) / turn + 1e-9) if turn else np.zeros_like(positions)
    at = (positions - full)[:, None]
    inside = ((at >= spans[:, 0]) & (at <= spans[:, 1])).any(axis=1)
    ends = np.concatenate([spans.ravel() + k * turn for k in (0, 1, -1)])
    end = ends[np.abs(ends - at).argmin(axis=1)]
    near = np.abs(end + full - positions) <= np.maximum(half, 1e-12 * (1 + np.abs(positions)))
    # not moved by the difference: an end is exact to the last bit
    return np.where(near & ~inside, end + full, positions)


def _lead(problem: Problem) -> float:
    """What the oracle's angle of the drive is ahead of the angle that the problem gives (its zero, its lean)."""
    drive = problem.mechanism.drive
    if drive.between:
        return 0.0
    given = next((datum.si for datum in problem.given.motion if datum.symbol == f"φ_{drive.link}"), drive.position)
    return drive.position - given


def _drive(sheet: Sheet, heading: Heading, drive: Drive, scale: float, notes: list[Words]) -> Reals:
    """The drive's positions in rad or m; TableError where one is missing."""
    values = _values(sheet, heading)
    if not np.isfinite(values).all():
        row = int(np.flatnonzero(~np.isfinite(values))[0])
        raise TableError(
            sheet.at(sheet.lines[row], heading.index)
            + Words("：缺少原动件的位置", ": the position of the drive is missing")
        )
    if (np.ptp(values)) == 0:
        raise TableError(
            Words(
                f"{sheet.name}：各行中原动件位置均为 {values[0]:g}；其位置应各不相同",
                f"{sheet.name}: the drive stands at {values[0]:g} in every row; its positions must differ",
            )
        )
    unit = heading.unit
    if unit is None:
        large = float(np.abs(values).max()) > (20 * scale if drive.slide else 2 * pi + 0.02)
        unit = (MM if large else M) if drive.slide else (DEG if large else RAD)
        notes.append(guessed(heading.text, unit))
    values = values * unit.factor
    return (
        values if drive.slide or unit.name == "deg" else _whole_degrees(values, _halves(sheet, heading) * unit.factor)
    )


def _whole_degrees(values: Reals, half: Reals) -> Reals:
    """Rounded radians are the round degrees that they stand for."""
    for step in _STEPS:
        whole = np.radians(np.round(np.degrees(values) / step) * step)
        if (np.abs(whole - values) <= half * (1 + 1e-6)).all() and len(np.unique(whole)) == len(np.unique(values)):
            return np.asarray(whole)
    return values


def _values(sheet: Sheet, heading: Heading) -> Reals:
    return np.array([sheet.number(heading.index, row) for row in range(len(sheet.rows))])


def _halves(sheet: Sheet, heading: Heading) -> Reals:
    """Half a unit of the last digit of every cell."""
    return np.array([last_unit(text) / 2 for text in sheet.column(heading.index)])


def _numbered(sheet: Sheet, head: Headings, mech: Mechanism, motion: Motion, notes: list[Words]) -> Headings:
    """The same with the problem's link numbers, where the table has others."""
    raw = []
    for heading in head.columns:
        assert heading.target is not None
        if not heading.said:
            values = _values(sheet, heading)
            raw.append((heading.target, values * (heading.unit or unit_by_size(heading.target, values)).factor))
    way = renumbered(raw, mech, motion)
    if not way:
        return head
    theirs, ours = (", ".join(names) for names in (way, way.values()))
    notes.append(
        Words(
            f"表中构件编号与题目不同：按转角判断，表中的构件 {theirs} 即题目的构件 {ours}。".replace(", ", "、"),
            f"The table numbers its links differently: judging by their angles, its links {theirs} are the "
            f"problem's links {ours}.",
        )
    )
    columns = tuple(
        replace(h, target=h.target.on(way[h.target.of_link]), renumbered=h.target.named_as_in(h.text))
        if h.target and not h.said and h.target.of_link in way
        else h
        for h in head.columns
    )
    return replace(head, columns=columns)


def _column(sheet: Sheet, heading: Heading, motion: Motion, notes: list[Words]) -> Column:
    target = heading.target
    assert target is not None
    values, half, exact = _values(sheet, heading), _halves(sheet, heading), target.of(motion)
    if np.isfinite(values).sum() < 3:
        raise TableError(
            Words(
                f"{sheet.name}：列“{heading.text}”只有 {np.isfinite(values).sum()} 个数；至少需要 3 个",
                f"{sheet.name}: column '{heading.text}' has {np.isfinite(values).sum()} numbers; at least 3 are needed",
            )
        )
    unit = heading.unit or fitting(target, values, exact)
    if heading.unit is None:
        notes.append(guessed(heading.text, unit))
    values, half = values * unit.factor, half * unit.factor
    if target.other is not None and target.other.is_transmission:  # some tell the obtuse one
        values = folded(values)
    column = Column(
        header=heading.text,
        target=target,
        values=values,
        half=half,
        texts=sheet.column(heading.index),
        unit=unit.name,
        factor=unit.factor,
        renumbered=heading.renumbered,
        floor=_floor(target, motion.mech),
    )
    return _directed(column, exact, notes)


def _floor(target: Target, mech: Mechanism) -> float:
    """Rounding noise of a quantity that is zero, from the size and the speed of the mechanism; of a force 1e-9 N."""
    size, rate = mech.scale, max(abs(mech.drive.rate), 1e-9) / (mech.scale if mech.drive.slide else 1.0)
    return 1e-11 * {
        "rad": 1.0,
        "rad/s": rate,
        "rad/s^2": rate**2,
        "m": size,
        "m/s": size * rate,
        "m/s^2": size * rate**2,
    }.get(target.unit, 100.0)


def _directed(column: Column, exact: Reals, notes: list[Words]) -> Column:
    """An angle may be counted along the link from its other end: that is no mistake."""
    if not column.target.is_angle:
        return column
    off = (column.values - exact)[column.there]
    if np.nanmedian(np.abs(wrapped(off - pi))) > min(NEAR, 0.25 * float(np.nanmedian(np.abs(wrapped(off))))):
        return column
    notes.append(
        Words(
            f"{column.header}：沿构件反方向计量，与题目所取方向差 180°（不算错误）",
            f"{column.header}: counted along the link from its other end, 180° from the "
            "problem's direction (no mistake)",
        )
    )
    return replace(column, values=column.values - pi, turned=pi)


def shown_position(value: float, slide: bool) -> str:
    """A position of the drive as text: 90°, 12 mm."""
    return f"{round(value, 9) + 0.0:.6g}{' mm' if slide else '°'}".replace("-", "−")

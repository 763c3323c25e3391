"""Somebody's own readings and points, as they are handed in: a student's, with whom the construction goes on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches

from .board.acts import Act, Area, Locate, Measure
from .board.otherwise.amended import Amended, plain_letters
from .board.otherwise.possible import slips_of
from .board.otherwise.slip import TOLD_OF, Mistake, Slip
from .errors import ArgumentError, UnknownNameError
from .foundation.frozen import FrozenMap
from .units.reading import Dim, read
from .words import Words

Length = float | str  # mm on paper (mm² of an area), or with its unit: "38 mm", "412 mm^2"
# mm on paper, right and up from where the figure has its origin: the pole of a polygon
Spot = complex | tuple[Length, Length]


def amend(
    readings: Mapping[str, Length] | None, points: Mapping[str, Spot] | None, slip: Slip | None = None
) -> Amended:
    """The amendments as the board takes them (mm); raises FaultError for what is no length."""
    return Amended(
        readings=FrozenMap({_plain(key): _read(value) for key, value in (readings or {}).items()}),
        points=FrozenMap({_plain(key): _spot(key, value) for key, value in (points or {}).items()}),
        slip=slip,
    )


def found_all(amended: Amended, acts: Sequence[Act], written: Mapping[str, Length] | None = None) -> None:
    """Raise UnknownNameError for an amendment that nothing on the sheet answers to, or more than one figure;
    FaultError for a length where an area was measured, and the other way round, as they were written."""
    for key, value in (written or {}).items():
        _of_its_kind(_plain(key), value, acts)
    _known(amended.readings, [act for act in acts if isinstance(act, Measure | Area)], Words("读数", "reading"))
    _known(amended.points, [act for act in acts if isinstance(act, Locate)], Words("点", "point"))


def can_be_made(slip: Slip, acts: Sequence[Act]) -> None:
    """Raise UnknownNameError for a mistake that nobody can make with these acts, those of the right solution: it would
    change nothing, and what is drawn would be taken for wrong."""
    there = [act for act in acts if slip.key in act.names]
    if not there:
        raise UnknownNameError(
            Words(f"图上没有 {slip.key}，不能在此出错", f"there is no {slip.key} on the sheet to make a mistake with"),
            code="unknown-act",
        )
    if slip.mistake is Mistake.OTHER_CENTRE:
        _known([slip.instead], [act for act in acts if isinstance(act, Locate)], Words("瞬心", "centre"))
        return  # found later than the line is drawn, at this scale, it misleads nobody
    made = [one for one in slips_of(acts) if any(one.key in act.names for act in there)]
    if not any((one.mistake, one.instead) == (slip.mistake, slip.instead) for one in made):
        zh, en = ("、".join(one.words.zh for one in made), "; ".join(map(str, made)))
        letter = "" if slip.mistake in TOLD_OF or not slip.instead else f"（{slip.instead}）"
        raise UnknownNameError(
            Words(
                f"解题中不会有“{slip.words.zh}{letter}”这样的错误；{slip.key} 处可有的错误：{zh or '无'}",
                f"nobody can make the mistake '{slip}'; those that can be made with {slip.key}: {en or 'none'}",
            ),
            code="unknown-slip",
        )


def _known(given: Iterable[str], acts: Sequence[Act], what: Words) -> None:
    for key in given:
        full = sorted({act.names[0] for act in acts if key in act.names})
        if not full:
            there = list(dict.fromkeys(act.key for act in acts))
            near = get_close_matches(key, there, n=3, cutoff=0.4) or there
            raise UnknownNameError(
                Words(
                    f"图上没有名为 {key} 的{what.zh}；有 {'、'.join(near)}",
                    f"there is no {what.en} '{key}' on the sheet; there are {', '.join(near)}",
                ),
                code="unknown-act",
            )
        if len(full) > 1:
            raise UnknownNameError(
                Words(
                    f"{what.zh} {key} 在几个图上都有；请写 {'、'.join(full)} 之一",
                    f"the {what.en} '{key}' stands on several figures; write one of {', '.join(full)}",
                ),
                code="ambiguous-act",
            )


def _of_its_kind(key: str, value: Length, acts: Sequence[Act]) -> None:
    """Nothing, where the unit of somebody's reading is that of what was read."""
    areas = [isinstance(act, Area) for act in acts if isinstance(act, Measure | Area) and key in act.names]
    if isinstance(value, str) and areas:
        read(value, Dim.AREA if all(areas) else Dim.LENGTH)


def _plain(key: str) -> str:
    return f"{key.rpartition(':')[0]}{key.rpartition(':')[1]}{plain_letters(key.rpartition(':')[2])}"


def _mm(value: Length) -> float:
    return read(value, Dim.LENGTH).si * 1000.0 if isinstance(value, str) else float(value)


def _read(value: Length) -> float:
    """A length in mm, or an area in mm²: what its unit says."""
    return read(value, Dim.AREA).si * 1e6 if isinstance(value, str) and _squared(value) else _mm(value)


def _squared(value: str) -> bool:
    return "2" in value.translate(_RAISED).rpartition("m")[2]


_RAISED = str.maketrans("²", "2")


def _spot(key: str, value: Spot) -> complex:
    if isinstance(value, int | float | complex):
        return complex(value)
    if len(value) != 2:
        raise ArgumentError(
            Words(
                f"点 {key} 需要两个坐标 (x, y)，而不是 {value!r}",
                f"the point {key} needs two coordinates (x, y), not {value!r}",
            ),
            code="point",
        )
    return complex(_mm(value[0]), _mm(value[1]))

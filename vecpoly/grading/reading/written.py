"""One answer as it was written: the raw text is kept, and what cannot be read says so;
blank is not 0, and neither is “—”.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from ...words import Words
from .characters import plain
from .direction import Pointing, split_direction
from .minutes import beyond_sixty, in_degrees
from .number import NUMBER, number
from .pair import Pair, in_brackets, without_brackets
from .sense import split_sense
from .unit import Unit, unit
from .yes_no import yes_or_no

LONGEST = 80  # characters that an answer has at most


class State(StrEnum):
    """What became of a cell."""

    READ = "read"
    BLANK = "blank"  # nothing was written
    NONE = "none"  # it was written that there is none: —
    UNREADABLE = "unreadable"
    AMBIGUOUS = "ambiguous"  # its parts contradict each other


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """raw: as it stands in the file. value: the number, with the sign that it has; unit: None where none was written.

    sense: 1 counter-clockwise, −1 clockwise, 0 not said. direction: of a vector. at: two coordinates. digits:
    significant ones; last: one unit of the last. why: what cannot be read, or contradicts itself.
    """

    raw: str
    state: State
    value: float = 0.0
    signed: bool = False
    unit: Unit | None = None
    sense: int = 0
    direction: Pointing | None = None
    at: tuple[float, float] | None = None
    yes: bool | None = None
    digits: int = 0
    last: float = 0.0
    why: Words | None = None


_TWO_WAYS = Words("写了两个不同的方向", "two directions are written, and are not one")
_NONE = {
    "-",
    "--",
    "---",
    "—",
    "——",
    "―",
    "/",
    "\\",
    "无",
    "没有",
    "none",
    "n/a",
    "na",
    "nil",
    "未作",
    "未做",
    "没做",
    "没作",
    "不会",
    "?",
    "×",
    "x",
}
_LEAD = re.compile(r"^(?:[A-Za-zΑ-ω][\w^{}]*\s*[=≈:])?(?:[≈~=≅]|约为|约|大约|about|ca\.?|approx\.?|\s)*", re.I)
_WITHIN = re.compile(r"\s*(?:(?:±|\+/?-)\s*\d+(?:\.\d+)?|左右|上下)")  # 0.3 ± 0.01, 约 0.3 左右
_ALONE = re.compile(r"\(([^(),;]+)\)(.*)")  # (0.3) m/s
_FRACTION = re.compile(r"([+-]?\d+(?:\.\d+)?)\s*/\s*(\d+(?:\.\d+)?)(?![\d.])")
_DATE = re.compile(r"(?:\d{4}-\d{2}-\d{2}(?: \d{2}:\d{2}:\d{2})?|\d{1,2}:\d{2}:\d{2})(?!\S)")  # also before a direction
_FORMULA = re.compile(r"=\s*-?(?:\$?[A-Z]{1,3}\$?\d|[A-Z]{2,}\(|\(?[\d.]+\s*(?!\*\s*10\s*\^)[*/+-]\s*[\d(A-Z$])")


def written(raw: str | float | None) -> Written:
    """What was written in a cell, or on a command line."""
    text = "" if raw is None else f"{raw:.15g}" if isinstance(raw, float) else str(raw)
    bare = plain(text)
    if not bare:
        return Written(raw=text, state=State.BLANK)
    if bare.lower() in _NONE:
        return Written(raw=text, state=State.NONE, yes=False if bare in ("无", "没有", "×", "x") else None)
    if (truth := yes_or_no(bare)) is not None:
        return Written(raw=text, state=State.READ, yes=truth)
    if (why := _spoilt(bare)) is not None:
        return _refused(text, why)
    if len(bare) > LONGEST:
        return _refused(text, Words("过长，不像一个答案", "too long for an answer"))
    if (two := in_brackets(bare)) is not None:
        return _place(text, two)
    one = _one(text, _unwrapped(bare))
    two = without_brackets(bare) if one.state is State.UNREADABLE else None
    return one if two is None else _place(text, two)


def _unwrapped(bare: str) -> str:
    """The number without what only leads to it, wraps it or tells its accuracy; a fraction reckoned out."""
    found = _ALONE.sub(r"\1\2", _LEAD.sub("", bare).rstrip(".,; "), count=1) if bare else bare
    found = _WITHIN.sub("", found, count=1)
    if (part := _FRACTION.match(found)) is not None and float(part[2]):
        return f"{float(part[1]) / float(part[2]):.4g}{found[part.end() :]}"
    return found


def _spoilt(bare: str) -> Words | None:
    """What a spreadsheet made of an answer: a date of 3-2, a formula whose value was never reckoned."""
    if _DATE.match(bare):
        return Words(
            "表格软件把它变成了日期或时刻；请作为文本重新输入",
            "a spreadsheet made a date or a time of it; type it again, as text",
        )
    if _FORMULA.match(bare):
        return Words(
            "这是公式，文件里没有它的值；请用表格软件打开、保存后再交",
            "it is a formula, and the file does not hold its value; open the file in a spreadsheet and save it again",
        )
    return None


def _one(raw: str, bare: str) -> Written:
    """A number with what stands beside it."""
    if beyond_sixty(bare):
        return _refused(raw, Words("分、秒应小于 60", "minutes and seconds of arc are below 60"))
    arc, bare = bare, in_degrees(bare)
    is_arc = arc != bare
    bare, direction = split_direction(bare)
    bare, before = split_direction(bare.rstrip()) if direction is not None else (bare, None)
    if direction is not None and before is not None:  # an arrow, and the column for directions too
        if direction.beside(before.degrees) > direction.reach + before.reach:
            return Written(raw=raw, state=State.AMBIGUOUS, why=_TWO_WAYS)
        direction = min(direction, before, key=lambda one: one.reach)
    bare, senses = split_sense(bare)
    found = NUMBER.match(bare)
    if found is None:
        return _refused(raw, Words("其中没有可读的数", "there is no number in it"))
    value = number(found)
    if isinstance(value, Words):
        return _refused(raw, value)
    named = bare[found.end() :].strip().rstrip(".,;").strip()
    known = unit(named) if named else None
    if named and known is None:
        return _refused(raw, _beside(named))
    sense = senses[0] if senses else 0
    if len(set(senses)) > 1 or (sense and value.signed and value.value and (value.value > 0) != (sense > 0)):
        return Written(raw=raw, state=State.AMBIGUOUS, value=value.value, unit=known, why=_both(len(set(senses)) > 1))
    return Written(
        raw=raw,
        state=State.READ,
        value=value.value,
        signed=value.signed,
        unit=known,
        sense=sense,
        digits=0 if is_arc else value.digits,  # of minutes of arc none are counted
        last=value.last,
        direction=direction,
    )


def _beside(named: str) -> Words:
    """What stands beside a number and is neither a unit nor, behind ∠, a direction."""
    before, angle, way = named.partition("∠")
    if angle and way.strip() and (not before.strip() or unit(before.strip())):
        said = way.strip()
        return Words(f"“{said}”不是可识别的方向", f"'{said}' is no direction that is known")
    return Words(f"“{named}”不是可识别的单位", f"'{named}' is no unit that is known")


def _both(senses: bool) -> Words:
    """That two things that were written of a sense are not one."""
    if senses:
        return Words("写了两个相反的转向", "two senses are written, one against the other")
    return Words("符号与转向互相矛盾", "its sign and its sense contradict each other")


def _place(raw: str, two: Pair) -> Written:
    """Two coordinates, with one unit behind them or each with its own."""
    parts = [_one(raw, part) for part in two[:2]]
    bad = next((part for part in parts if part.state is not State.READ), None)
    if bad is not None:
        return bad
    behind = unit(two[2]) if two[2] else None
    units = {part.unit for part in parts if part.unit} | ({behind} if behind else set())
    if len(units) > 1 or (two[2] and behind is None):
        return _refused(
            raw, Words("两个坐标的单位不一致，或不可识别", "the units of the coordinates differ, or are not known")
        )
    return Written(
        raw=raw,
        state=State.READ,
        at=(parts[0].value, parts[1].value),
        unit=next(iter(units), None),
        last=max(part.last for part in parts),
        digits=min(part.digits for part in parts),
    )


def _refused(raw: str, why: Words) -> Written:
    return Written(raw=raw, state=State.UNREADABLE, why=why)

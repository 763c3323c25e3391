"""Links as written (``BC: 350 mm``, ``block: F``, ``slot: G``):
their first points, guide lines, gears, discs and faces."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from ...errors import FaultError
from ...units.reading import positive
from ...words import Words
from ..problem import Shape
from ..schema.faults import meant, not_on_link
from ..text.source import Value
from .circles import give_circle
from .draft import ONE, TWO, Draft, Line, letters_of
from .lines import read_line
from .lines_told import note_lines
from .places import place
from .profiles import give_profile
from .starts import read_start
from .teeth import read_pressure_angle

_SINGLE = {
    "block": Shape.BLOCK,
    "slot": Shape.SLOT,
    "rod": Shape.ROD,
    "cylinder": Shape.CYLINDER,
    "piston": Shape.PISTON,
    "gear": Shape.GEAR,
    "rack": Shape.ROD,
    "disc": Shape.BAR,
    "face": Shape.BAR,
}
_LINED = ("slot", "rod")  # what has a line of its own, through its pin or beside it
_PLACED = ("gear", "rack", "disc", "face")  # what may name a point that is set out further on
LINK_KEYS = (*_SINGLE, "cam", "radius", "alpha", "phi", "s")


def read_link(name: str, data: Value) -> Draft:
    """One entry of `links`."""
    if not isinstance(data, dict) or not data:
        raise FaultError(
            Words(
                f"构件 {name} 应写成 {{BC: 350 mm}} 或 {{block: C}} 之类的映射",
                f"link {name} needs a mapping such as {{BC: 350 mm}} or {{block: C}}",
            ),
            code="missing",
        )
    draft = Draft(name)
    for key in data:
        _known(key)
    if "cam" in data:
        give_profile(draft, data)
        return draft
    _base(draft, data)
    _set_out(draft, data)
    give_circle(draft, data)
    read_pressure_angle(draft, data)
    read_start(draft, data)
    return draft


def _set_out(draft: Draft, data: Mapping[str, Value]) -> None:
    """Further points and the link's own line: each as soon as there is what it is set out from."""
    waiting: dict[str, Callable[[], None]] = {}
    draft.later = frozenset(key for key in data if ONE.fullmatch(key))  # no ray goes to one of these before it is there
    for key, value in data.items():
        if ONE.fullmatch(key):
            waiting[key] = partial(place, draft, key, value)
        elif key in _LINED and isinstance(value, dict):
            waiting[key] = partial(_own_line, draft, key, value)
        elif key in _FLANKS:
            waiting[key] = partial(_FLANKS[key], draft, value)
    while waiting:
        done = [key for key, act in waiting.items() if _succeeds(act)]
        if not done:  # nothing gets any further: the faults are told in their order
            for key, act in waiting.items():
                _within(key, act)
        waiting = {key: act for key, act in waiting.items() if key not in done}
    note_lines(draft, data)


def _succeeds(act: Callable[[], None]) -> bool:
    try:
        act()
    except FaultError:
        return False
    return True


def _own_line(draft: Draft, key: str, data: Mapping[str, Value]) -> None:
    """The line of a slot or a rod that passes at an angle, or beside a point."""
    draft.line = read_line(draft, data, key)


def _rack(draft: Draft, data: Value) -> None:
    """The pitch line; a rack that has but this one point is directed along it."""
    draft.rack = read_line(draft, data if isinstance(data, dict) else {"through": str(data)}, "rack")
    if len(draft.points) == 1 and draft.line is None and draft.shape is not Shape.BLOCK:
        draft.line = Line(draft.rack.origin, draft.rack.direction, draft.rack.through)


def _face(draft: Draft, data: Value) -> None:
    """The face, and the direction of a link that has but one point and no guide."""
    if not isinstance(data, dict):
        data = {"through": str(data)}
    draft.face = read_line(draft, data, "face")
    if draft.shape is Shape.BAR and len(draft.points) == 1:
        draft.line = draft.face


_FLANKS = {"rack": _rack, "face": _face}


def _within(key: str, act: Callable[[], None]) -> None:
    try:
        act()
    except FaultError as fault:
        raise fault.under(key) from None


def _known(key: str) -> None:
    if not (key in LINK_KEYS or ONE.fullmatch(key) or TWO.fullmatch(key)):
        raise FaultError(
            Words(
                f"“{key}”不是构件的键（应为两个字母及其长度、一个字母及其位置，或 {', '.join(LINK_KEYS)}）",
                f"'{key}' is no key of a link (two letters with a length, a letter with its place, or "
                f"{', '.join(LINK_KEYS)})",
            )
            + (meant(key, LINK_KEYS) if len(key) > 2 else Words.same("")),
            key,
            code="unknown-key",
        )


def _base(draft: Draft, data: Mapping[str, Value]) -> None:
    """The first points: a length such as BC, or the one pin of a block, slot, rod or gear."""
    bases = [key for key in data if TWO.fullmatch(key)]
    singles = [key for key in _SINGLE if isinstance(data.get(key), str)]
    if len(bases) > 1:
        raise FaultError(
            Words(
                f"{bases[1]}：构件 {draft.name} 已给长度 {bases[0]}；其他点请用位置给出，如 E: {{BE: 60 mm, CE: "
                "70 mm, side: left of BC}",
                f"{bases[1]}: link {draft.name} already has the length {bases[0]}; set further points out, e.g. "
                "E: {BE: 60 mm, CE: 70 mm, side: left of BC}",
            ),
            bases[1],
            code="contradiction",
        )
    if bases:
        first, second = letters_of(bases[0])
        _within(bases[0], lambda: _bar(draft, first, second, data[bases[0]]))
    _one_shape(draft, data, bases)
    for key in singles:
        _pinned(draft, key, str(data[key]), data)
    for key in (*_LINED, "rack", "face"):
        led = data.get(key)
        if not draft.points and isinstance(led, dict) and ONE.fullmatch(str(led.get("through"))):
            draft.shape, draft.points[str(led["through"])] = _SINGLE[key], 0j
    if not draft.points:
        raise FaultError(
            Words(
                f"构件 {draft.name} 没有长度；请写两个字母及其长度，如 {{BC: 350 mm}}，或写滑块、导杆、穿杆、"
                "缸体、活塞、齿条、齿轮、圆盘、平面的一个铰链，如 {block: C}",
                f"link {draft.name} has no length: write two letters and a length, e.g. {{BC: 350 mm}}, or the "
                "one pin of a block, slot, rod, cylinder, piston, rack, gear, disc or face, e.g. {block: C}",
            ),
            code="missing",
        )


def _pinned(draft: Draft, key: str, letter: str, data: Mapping[str, Value]) -> None:
    """The one pin of a block, slot, rod or gear: the link's first point where it has none yet."""
    if not ONE.fullmatch(letter):
        raise FaultError(
            Words(f"“{letter}”不是点的字母；应写 C 之类的大写字母", f"'{letter}' is no letter of a point, such as C"),
            key,
            code="spelling",
        )
    if not draft.points and not (key in _PLACED and letter in data):
        draft.shape, draft.points[letter] = _SINGLE[key], 0j
    elif letter not in draft.points and key not in _PLACED:
        raise not_on_link(letter, draft.name, draft.points, key)
    if key in (*_LINED, "cylinder"):
        draft.line = Line(draft.points[letter], 0.0, letter)


def _one_shape(draft: Draft, data: Mapping[str, Value], bases: list[str]) -> None:
    """Raise FaultError where two keys say two things of what the link is, of which one would have to be ignored."""
    pairs = [("slot", "rod"), *((base, "block") for base in bases)]
    for one, other in pairs:
        if one in data and other in data:
            raise FaultError(
                Words(
                    f"构件 {draft.name} 同时写有 {one} 和 {other}，二者只能取一：滑块只有一个铰链点，导路只有一条",
                    f"link {draft.name} has both {one} and {other}, of which one would be "
                    "ignored: a block has but its one pin, a link one guide line; leave one "
                    "out",
                ),
                other,
            )


def _bar(draft: Draft, first: str, second: str, value: Value) -> None:
    if first == second:
        raise FaultError(Words(f"长度的两端都是 {first}", f"a length from {first} to itself"))
    length = positive(value)
    draft.points |= {first: 0j, second: complex(length.si)}
    draft.note(f"l_{first}{second}", length.si, length.text)

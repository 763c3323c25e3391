"""The motion of a cam's follower over one turn, as it is written: `rise 30 mm in 120 deg cosine`, `dwell 30 deg`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from math import degrees, pi, tau
from typing import Literal

from ...errors import FaultError
from ...foundation.slotted import replace
from ...units.reading import Dim, positive
from ...words import Words

EXAMPLE = "rise 30 mm in 120 deg cosine"
JUST = 1e-13  # of a piece: so little before its end, or its middle
TURN = 1e-9  # rad: angles nearer than this are one
WHOLE = 2e-5  # rad: by how much the angles, each told with six digits, may miss a whole turn
LEVEL = 1e-9  # of the stroke: by how much the follower may miss its lowest place
_WRITTEN = re.compile(
    r"(?P<what>rise|return|dwell)(?:\s+(?P<by>\S.*?))??(?:\s+(?:in|for))?\s+(?P<angle>[\d.]+\s*(?:deg|rad|°))"
    r"(?:\s+(?P<law>[a-z][a-z-]*|3-4-5))?"
)


class Law(StrEnum):
    """How the follower moves between two levels."""

    UNIFORM = "uniform"
    PARABOLIC = "parabolic"
    COSINE = "cosine"
    SINE = "sine"
    POLYNOMIAL = "3-4-5"

    @property
    def called(self) -> Words:
        """等速运动, uniform motion."""
        return _CALLED[self]

    @property
    def fastest(self) -> float:
        """The greatest ds/dφ of a rise by 1 in an angle of 1."""
        return _FASTEST[self]


_CALLED = {
    Law.UNIFORM: Words("等速运动", "uniform motion"),
    Law.PARABOLIC: Words("等加速等减速运动", "constant acceleration and deceleration"),
    Law.COSINE: Words("余弦加速度（简谐）运动", "simple harmonic motion (cosine acceleration)"),
    Law.SINE: Words("正弦加速度（摆线）运动", "sine acceleration (cycloidal motion)"),
    Law.POLYNOMIAL: Words("3-4-5 次多项式运动", "3-4-5 polynomial motion"),
}

_FASTEST = {Law.UNIFORM: 1.0, Law.PARABOLIC: 2.0, Law.COSINE: pi / 2, Law.SINE: 2.0, Law.POLYNOMIAL: 15 / 8}


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """One entry as written; by: how far it rises or returns, as text."""

    what: Literal["rise", "return", "dwell"]
    by: str | None
    angle: float
    law: Law | None
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Piece:
    """Part of a turn: from the angle `start` over `angle` (rad), from the level `low` to `high` (m, or rad of an arm).

    rises: +1 from low to high, −1 from high to low, 0 at rest on `low` (then equal to `high`), without a law.
    """

    start: float
    angle: float
    low: float
    high: float
    rises: int
    law: Law | None

    @property
    def end(self) -> float:
        """The angle at which it ends."""
        return self.start + self.angle

    @property
    def lift(self) -> float:
        """How far it lifts the follower, or lets it down."""
        return self.high - self.low


def read_entry(text: object) -> Entry:
    """One entry of `motion:`; raises FaultError with how it is written."""
    if isinstance(text, Entry):
        return text
    found = _WRITTEN.fullmatch(str(text).strip()) if isinstance(text, str) else None
    if found is None or (found["what"] == "dwell") != (found["law"] is None):
        raise _unreadable(text)
    what, name = found["what"], found["law"]
    if name is not None and name not in [law.value for law in Law]:
        known = ", ".join(Law)
        raise FaultError(
            Words(f"“{name}”不是运动规律；可用 {known}", f"'{name}' is no law of motion; there are {known}"),
            code="unknown-name",
        )
    if (what == "rise") != (found["by"] is not None) and what != "return":
        raise _unreadable(text)
    return Entry(
        what=what,  # type: ignore[arg-type]  # the pattern knows these three
        by=found["by"],
        angle=positive(found["angle"], Dim.ANGLE).si,
        law=Law(name) if name is not None else None,
        text=str(text).strip(),
    )


def _unreadable(text: object) -> FaultError:
    return FaultError(
        Words(
            f"“{text}”不是从动件的运动；如写 {EXAMPLE}、dwell 30 deg、return in 120 deg sine",
            f"'{text}' is no motion of a follower; write e.g. {EXAMPLE}, dwell 30 deg, return in 120 deg sine",
        ),
        code="spelling",
    )


@lru_cache(maxsize=64)
def pieces_of(entries: tuple[Entry, ...], dim: Dim) -> tuple[Piece, ...]:
    """The pieces of a whole turn, each level a length or an angle, the last one as long as the turn leaves it; raises
    FaultError where they make no turn."""
    pieces, start, level = [], 0.0, 0.0
    for entry in entries:
        by = level if entry.by is None else positive(entry.by, dim).si
        rises = {"rise": 1, "return": -1, "dwell": 0}[entry.what]
        after = level + rises * by if rises else level
        if after < -LEVEL * by or (rises < 0 and level == 0):
            raise FaultError(
                Words(
                    f"“{entry.text}”：从动件此时并未升到这样高，不能再下降；请核对各段行程",
                    f"'{entry.text}': the follower does not stand that high and cannot return so far; check the "
                    "strokes",
                ),
                code="contradiction",
                keys=("motion",),
            )
        low, high = sorted((level, after if after > LEVEL * by else 0.0))
        pieces.append(Piece(start=start, angle=entry.angle, low=low, high=high, rises=rises, law=entry.law))
        start, level = start + entry.angle, high if rises > 0 else low
    _closes(pieces, start, level, dim)
    last = pieces[-1]
    return (*pieces[:-1], replace(last, angle=tau - last.start))


def _closes(pieces: Sequence[Piece], turn: float, level: float, dim: Dim) -> None:
    if abs(turn - tau) > WHOLE:
        raise FaultError(
            Words(
                f"motion：各段转角之和为 {degrees(turn):.6g} deg；一周应为 360 deg，请补上或减去 "
                f"{abs(360 - degrees(turn)):.6g} deg",
                f"motion: the angles add up to {degrees(turn):.6g} deg; a turn has 360 deg, so "
                f"{'add' if turn < tau else 'take away'} {abs(360 - degrees(turn)):.6g} deg",
            ),
            code="contradiction",
            numbers={"sum": degrees(turn)},
            keys=("motion",),
        )
    highest = max((piece.high for piece in pieces), default=0.0)
    if not highest:
        raise FaultError(
            Words(f"motion：从动件没有推程；如写 {EXAMPLE}", f"motion: the follower never rises; write e.g. {EXAMPLE}"),
            code="missing",
            keys=("motion",),
        )
    if level > LEVEL * highest:
        left = f"{degrees(level):.6g} deg" if dim is Dim.ANGLE else f"{1e3 * level:.6g} mm"
        raise FaultError(
            Words(
                f"motion：一周之后从动件仍高出起始位置 {left}；请使各段回程之和等于推程",
                f"motion: after the turn the follower still stands {left} above its start; let it return as far as it "
                "rises",
            ),
            code="contradiction",
            keys=("motion",),
        )


def stations(pieces: Sequence[Piece], step: float) -> Iterator[tuple[float, Piece]]:
    """Angles of a turn every `step` (rad) and at the end of every piece, each with its piece: that which ends there."""
    for piece in pieces:
        first = int(piece.start / step + 1e-9) + 1
        inner = [k * step for k in range(first, int(piece.end / step) + 2) if k * step < piece.end - TURN]
        at_start = [0.0] if piece.start == 0 else []
        yield from ((phi, piece) for phi in (*at_start, *(p for p in inner if p > piece.start + TURN), piece.end))


def piece_at(pieces: Sequence[Piece], turn: float) -> tuple[Piece, float]:
    """The piece at an angle to which the cam has turned (rad), and that angle within its turn.

    Where something jumps it is the place just before: the end of a piece, also of the last, and of a parabola's half.
    """
    phi = turn % tau
    phi = phi + tau if phi <= TURN else phi
    piece = next((piece for piece in pieces if phi <= piece.end + TURN), pieces[-1])
    for end in (piece.start + piece.angle / 2, piece.end):
        if abs(phi - end) <= TURN:
            return piece, end - JUST * piece.angle
    return piece, phi

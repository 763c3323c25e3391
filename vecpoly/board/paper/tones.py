"""Which vectors of a problem are told apart, and by which tone: a number that the drawing turns into a hue.

One and the same motion, or force, has one tone wherever it appears: in its equation, in the polygons, on the diagram,
on free bodies. v_CB, a^n_CB and a^t_CB are the motion of C about B; R_12 and R_21 are the force in one joint, with
friction or without; W_1, W_1I and C_1 are what one mass of a rotor gives. What stands in one figure or in one equation
has different tones: first one of as many as there are hues, then one of a second series with the same hues and another
line; where these run out too, it has none. Two motions of one point that no figure and no equation shows together have
one tone: v_K and a_K4. Of those that are free a quantity has one that no other of its kind has, as far as they go: two
joints, or a joint and a load, are told apart also where no figure shows both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import chain

from ...algebra.formula import is_symbol
from ...figures.hue import TONES
from ...foundation.frozen import FrozenMap
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...names import ascii_key
from .marks import Mark, TurnArrow, Vector

HUES = len(TONES)
MANY = 2 * HUES
CLOSE = ((1, 7), (7, 8))  # blue and indigo, indigo and slate
_MOTION = pattern(r"\b[va][nktr]?_")
_POINTS = pattern(rf"({LETTER}\d*)({LETTER}\d*)")
_JOINT = pattern(r"R[nt]?('*)_([A-Z]?\d)([A-Z]?\d)(?:(_r)|\b)")
_MASS = pattern(r"[WC]_(\d+|b)(I*)")  # of a mass of a rotor: whole, its part in a plane, the couple that it makes
_COUPLE = pattern(r"F_M(I?\d+)")  # a couple as a force on a lever
_VIBRATION = "V_"  # at the start, V_0, and what a trial weight adds, V_t: of no other a part
_PRIME = "'"  # of the other sense of motion, in symbols; in keys it is _r
_DIGITS = pattern(r"\d+")
_PART = pattern(r"([_,](0|[nt]))+$")


@lru_cache(maxsize=4096)
def whose(key: str) -> str:
    """What a key is a part of: ``motion B-C`` of v_CB and at_CB, ``joint 1-2`` of R_21 and R_12_0, ``mass 1`` of W_1,
    W_1I and C_1, else the key."""
    if key.startswith(_VIBRATION):
        return key
    bare = _PART.sub("", key).strip("()")
    if _MOTION.match(bare):
        points = _MOTION.sub("", bare)
        pair = _POINTS.fullmatch(points)
        return f"motion {'-'.join(sorted(pair.groups())).strip('-') if pair else points}"
    if (mass := _MASS.fullmatch(bare)) is not None:
        return f"mass {mass[1]}{mass[2] if mass[1] == 'b' else ''}"
    joint = _JOINT.match(bare)
    if joint is None:
        return f"M_{couple[1]}" if (couple := _COUPLE.fullmatch(bare)) is not None else bare
    return f"joint{_PRIME if joint[4] else joint[1]} {'-'.join(sorted(joint.groups()[1:3]))}"


def key_of(mark: Mark) -> str:
    """The key of a mark; of an arrow that has a symbol, that of the symbol, by which equations know it."""
    return known_as(mark.key, mark.label) if isinstance(mark, Vector | TurnArrow) else mark.key


def known_as(key: str, symbol: str) -> str:
    """The key by which a quantity is told apart: that of its symbol (F′, which may be asked as F), else its own."""
    return ascii_key(symbol) if symbol and (not key or is_symbol(symbol)) else key


def tones(figures: Iterable[tuple[Mark, ...]], equations: Iterable[tuple[str, ...]]) -> Mapping[str, int]:
    """The tones by what has them (`whose`): first of what is written as an equation of symbols, then as it is drawn."""
    drawn = [tuple(dict.fromkeys(_vectors(marks))) for marks in figures]
    known = set(chain.from_iterable(drawn))
    written = [tuple(w for w in map(whose, map(ascii_key, symbols)) if w in known) for symbols in equations]
    beside: dict[str, set[str]] = {}
    for together in (*written, *drawn):
        for one in together:
            beside.setdefault(one, set()).update(together)
    found: dict[str, int] = {}
    for one in dict.fromkeys(chain.from_iterable((*written, *drawn))):
        taken = {found[other] for other in beside[one] if other in found}
        if free := [tone for tone in range(1, MANY + 1) if tone not in taken]:
            kin, alike, acting, used = (_used(found, one, test) for test in (_of_a_point, _of_a_kind, _of_a_sort, _any))
            close = _close(taken)
            found[one] = min(free, key=lambda t: (t > HUES, -kin[t], alike[t], acting[t], used[t], _hue(t) in close, t))
    return FrozenMap(found)


def _hue(tone: int) -> int:
    """Which of the hues it has."""
    return (tone - 1) % HUES + 1


def _close(taken: Iterable[int]) -> set[int]:
    """The hues that beside these take a second look to be told apart."""
    here = {_hue(tone) for tone in taken}
    return {other for pair in CLOSE for one, other in (pair, pair[::-1]) if one in here}


def _used(found: Mapping[str, int], one: str, test: Callable[[str, str], bool]) -> Counter[int]:
    """How often each tone is taken by what is like this one."""
    return Counter(tone for other, tone in found.items() if test(one, other))


def _of_a_point(one: str, other: str) -> bool:
    """Both motions, of a point and of the same as one of a link: v_K of the pitch point and a_K4."""
    return one.startswith("motion ") and _DIGITS.sub("", one) == _DIGITS.sub("", other)


def _of_a_kind(one: str, other: str) -> bool:
    """Both motions, both forces in joints, both loads."""
    return one.partition(" ")[0] == other.partition(" ")[0] if " " in one else " " not in other


def _of_a_sort(one: str, other: str) -> bool:
    """Both motions, or both forces."""
    return one.startswith("motion ") == other.startswith("motion ")


def _any(_: str, __: str) -> bool:
    return True


def _vectors(marks: tuple[Mark, ...]) -> Iterator[str]:
    """What the vectors and the lines of action of a figure belong to; then its couples."""
    for mark in marks:
        if (isinstance(mark, Vector) and key_of(mark)) or mark.key.startswith("R"):
            yield whose(key_of(mark))
    for mark in marks:
        if isinstance(mark, TurnArrow) and mark.label[:1] == "M":
            yield whose(key_of(mark))

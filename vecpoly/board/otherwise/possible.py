"""The mistakes that can be made at the board: read off the acts, with no code for any problem."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence

from ..acts import Act, Compute, Follow, Image, Invert, Judge, LayOff, Locate, Meet, Parallel, Ray, Touch, Transfer
from ..place import View, view_of
from .slip import Mistake, Slip
from .wrongly import before

NOTHING = 1e-6  # mm: a vector of no length cannot be drawn wrongly
KNOWN = (Mistake.REVERSED, Mistake.DROPPED, Mistake.TURNED, Mistake.HALVED, Mistake.DOUBLED, Mistake.SCALED)


def slips_of(acts: Sequence[Act]) -> tuple[Slip, ...]:
    """Every mistake that can be made with these acts."""
    named = zip(acts, _names(acts), strict=True)
    return tuple(dict.fromkeys(slip for act, name in named for slip in _of(act, acts, name)))


def _of(act: Act, acts: Sequence[Act], name: str) -> Iterator[Slip]:
    """The mistakes that can be made with one act."""
    match act:
        case LayOff(mm=mm) if act.key and mm > NOTHING:
            first = act.head.place is None or before(act.head.place, _drawn(acts)) is view_of(act.head.place)
            yield from (Slip(m, name) for m in KNOWN if not (first and m is Mistake.SCALED))
        case Transfer(by=by) if act.key and abs(by) > NOTHING:
            yield from (Slip(mistake, name) for mistake in KNOWN)
        case Follow(by=by) if abs(by) > NOTHING:
            yield from (Slip(mistake, name) for mistake in (Mistake.REVERSED, Mistake.DROPPED))
            yield from (Slip(Mistake.COINCIDENT, name, letter) for letter in _coincident(act, acts))
        case Parallel() if act.key and len(led := _on_line(act, acts)) > 1:
            yield from (Slip(Mistake.OTHER_CENTRE, name, letter) for letter in _beside(act, led, acts))
        case Parallel() if act.key:
            yield Slip(Mistake.TURNED, name)
        case Ray(known=True):
            yield Slip(Mistake.OTHER_SIDE, name)
        case Ray() if act.key:
            yield from (Slip(mistake, name) for mistake in (Mistake.COMPLEMENT, Mistake.OTHER_SIDE))
        case Invert():
            yield Slip(Mistake.FORWARDS, act.key)
        case Locate() if any(isinstance(met := acts[n], Meet) and met.other is not None for n in act.inputs):
            yield Slip(Mistake.OTHER_MEETING, name)
        case Locate() if any(isinstance(drawn := acts[n], Image) and drawn.other is not None for n in act.inputs):
            yield Slip(Mistake.TURNED_OVER, name)
        case Compute(chances=chances):
            yield from (Slip(mistake, name, instead) for mistake, instead in chances)
        case Judge(crosses=False):
            yield Slip(Mistake.COUNTED, name)
        case Touch(free=False) if act.key:
            yield Slip(Mistake.OTHER_TANGENT, act.key)
        case _:
            return


def _drawn(acts: Sequence[Act]) -> set[View]:
    """The kinds of figure on which there are acts."""
    return {view_of(act.head.place) for act in acts if act.head.place is not None}


def _on_line(act: Parallel, acts: Sequence[Act]) -> list[Locate]:
    """The lettered points through which a line was ruled."""
    spots = (one for n in sorted(act.inputs) if isinstance(one := acts[n], Locate) and one.figure == act.figure)
    return [one for one in spots if _is_on(act, one)]


def _is_on(line: Parallel, point: Locate) -> bool:
    return abs((line.along.conjugate() * (point.at - line.at)).imag) < NOTHING


def _beside(act: Parallel, led: Sequence[Locate], acts: Sequence[Act]) -> Iterator[str]:
    """The letters of the points found before that are not on the line, and are of the kind of those that are."""
    for one in acts[: act.number]:
        if (
            isinstance(one, Locate)
            and one.figure == act.figure
            and one.key[:1] == led[0].key[:1]
            and not _is_on(act, one)
        ):
            yield one.key


def _names(acts: Sequence[Act]) -> list[str]:
    """The key of each act, with its figure where the same key stands on several.

    What is laid off wrongly on the diagram, for want of knowing better, is so on every figure apart that shows it
    again: the offset of a cam's follower on the other side.
    """
    figures = defaultdict[tuple[type[Act], str], set[str]](set)
    for act in acts:
        figures[type(act), act.key].add(act.figure)
    several = (len(figures[type(act), act.key]) > 1 and act.head.place is not View.MECHANISM for act in acts)
    return [act.names[0] if act.key and there else act.key for act, there in zip(acts, several, strict=True)]


def _coincident(act: Follow, acts: Sequence[Act]) -> Iterator[str]:
    """The letters, on this polygon, of other links' points at the same place: b₃ for b₂."""
    tip = next((one for n in act.inputs if isinstance(one := acts[n], Locate)), None)
    if tip is None:
        return
    base = tip.key[:1]
    for one in acts[: act.number]:
        if (
            isinstance(one, Locate)
            and one.figure == tip.figure
            and one.key[:1] == base
            and one.key != tip.key
            and abs(one.at - tip.at) > NOTHING
        ):
            yield one.key

"""Where the figures stand on a sheet: also one that is turned, or in a mirror, or was put out at another size."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from ..model import DrawingKey
from .askew import lie_of
from .fit import Fit, fitted
from .held import MIRRORED, QUARTERS, UPRIGHT, Held
from .tidy import Strokes

SAME = 0.005  # of a scale
FOUND, CLEARLY = 0.9, 0.2  # a drawing found so far stands upright; one found so much better otherwise does not
SURE = 0.6  # of a figure found as it should be: no mistake need be sought to recognise it


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """The figures; held: how the sheet had to be held for them; printed: how much larger the sheet is than it says;
    declared: mm of the sheet for a mm of the reference, by figure, where it is stated."""

    fits: tuple[Fit, ...]
    held: Held = UPRIGHT
    printed: float = 1.0
    declared: Mapping[str, float] = field(default_factory=dict)


def find(key: DrawingKey, strokes: Strokes, scales: Mapping[str, float]) -> Found:
    """The figures of a sheet; scales: as declared, ``mu_v`` → SI per mm."""
    declared = {
        shape.name: shape.mu / scales[shape.view.mu.key] for shape in key.exact.shapes if shape.view.mu.key in scales
    }
    if (times := _times(key, strokes, declared)) != 1.0:
        larger = {name: scale * times for name, scale in declared.items()}
        return Found(fits=tuple(_upright(key, strokes, larger)), printed=times, declared=larger)
    fits = _upright(key, strokes, declared)
    share = _share(key, fits)
    if share >= FOUND:
        return Found(fits=tuple(fits), declared=declared)
    plain = [(shape,) for shape in key.exact.shapes]
    others = (*MIRRORED, *QUARTERS, *_as_the_diagram(key, strokes))
    ways = [(held, fitted(strokes, plain, declared, held=held)) for held in others]
    drawn = _diagram(fits)  # where it lies better upright it is no sheet that is mirrored, but a polygon
    fair = [
        (held, there) for held, there in ways if (_diagram(there) >= drawn if held.mirror else _diagram(there) >= FOUND)
    ]
    if not fair:
        return Found(fits=tuple(fits), declared=declared)
    held, best = max(fair, key=lambda way: _share(key, way[1]))
    if _share(key, best) > max(SURE, share + CLEARLY):
        return Found(fits=tuple(best), held=held, declared=declared)
    return Found(fits=tuple(fits), declared=declared)


def _as_the_diagram(key: DrawingKey, strokes: Strokes) -> Iterator[Held]:
    """The sheet turned so that its diagram is upright: paper may lie at any angle."""
    for shape in key.exact.shapes if strokes.parts else ():
        parts = range(max(strokes.parts) + 1) if shape.diagram else ()
        there = [[one for one, part in zip(strokes.lines, strokes.parts, strict=True) if part == p] for p in parts]
        lies = [lie for lines in there if (lie := lie_of(lines, shape, None)) is not None and not lie.held.mirror]
        yield from (lie.held for lie in sorted(lies, key=lambda lie: -lie.liked)[:1])


def _diagram(fits: Sequence[Fit]) -> float:
    """How much of the diagram was found: only with it is it the sheet that lies so, and not a polygon."""
    return max((fit.share for fit in fits if fit.shape.diagram), default=0.0)


def _upright(key: DrawingKey, strokes: Strokes, declared: Mapping[str, float]) -> list[Fit]:
    """The figures as they should be, or, where they are not found so, as a mistake makes them."""
    found = fitted(strokes, [(shape,) for shape in key.exact.shapes], declared)
    if all(fit.share >= SURE for fit in found) and not _left(strokes, found):
        return found
    return fitted(strokes, key.variants, declared)


def _left(strokes: Strokes, found: Sequence[Fit]) -> bool:
    """Whether vectors lie about that belong to no figure found so far."""
    taken, heads = {n for fit in found for n in fit.numbers}, any(one.headed for one in strokes.lines)
    return any(one.headed or not heads for n, one in enumerate(strokes.lines) if n not in taken)


def _times(key: DrawingKey, strokes: Strokes, declared: Mapping[str, float]) -> float:
    """How much larger than its stated scales the whole sheet is, where all figures agree."""
    free = fitted(strokes, [(shape,) for shape in key.exact.shapes], {}) if declared else []
    sure = [fit for fit in free if fit.shape.name in declared and fit.share >= SURE]
    times = [fit.measured / declared[fit.shape.name] for fit in sure]
    alike = len(times) > 1 and max(times) / min(times) - 1 < SAME and abs(times[0] - 1) > SAME
    return sum(times) / len(times) if alike else 1.0


def _share(key: DrawingKey, fits: Sequence[Fit]) -> float:
    """How much of all polygons lies where it should."""
    polygons = sum(not shape.diagram for shape in key.exact.shapes)
    return sum(fit.share for fit in fits if not fit.shape.diagram) / polygons if polygons else 0.0

"""Where the figures stand on a sheet: also one that is turned, or in a mirror, or was put out at another size."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..model import DrawingKey
from .fit import Fit, fitted
from .held import MIRRORED, QUARTERS, UPRIGHT, Held
from .tidy import Strokes

SAME = 0.005  # of a scale
FOUND, CLEARLY = 0.9, 0.2  # a drawing found so far stands upright; one found so much better otherwise does not
SURE = 0.6  # of a figure found as it should be: no mistake need be sought to recognise it


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """The figures; held: how the sheet had to be held for them; printed: how much larger the sheet is than it says."""

    fits: tuple[Fit, ...]
    held: Held = UPRIGHT
    printed: float = 1.0


def find(key: DrawingKey, strokes: Strokes, scales: Mapping[str, float]) -> Found:
    """The figures of a sheet; scales: as declared, ``mu_v`` → SI per mm."""
    declared = {
        shape.name: shape.mu / scales[shape.view.mu.key] for shape in key.exact.shapes if shape.view.mu.key in scales
    }
    if (times := _times(key, strokes, declared)) != 1.0:
        larger = {name: scale * times for name, scale in declared.items()}
        return Found(fits=tuple(_upright(key, strokes, larger)), printed=times)
    fits = _upright(key, strokes, declared)
    share = _share(key, fits)
    if share >= FOUND:
        return Found(fits=tuple(fits))
    plain = [(shape,) for shape in key.exact.shapes]
    ways = [(held, fitted(strokes, plain, declared, held=held)) for held in (*MIRRORED, *QUARTERS)]
    fair = [(held, fits) for held, fits in ways if held.mirror or _turned_with(fits)]
    held, best = max(fair, key=lambda way: _share(key, way[1]))
    if _share(key, best) > max(SURE, share + CLEARLY):
        return Found(fits=tuple(best), held=held)
    return Found(fits=tuple(fits))


def _turned_with(fits: Sequence[Fit]) -> bool:
    """Whether the diagram was found too: only then is it the sheet that is turned, and not a polygon."""
    return any(fit.shape.diagram and fit.share >= FOUND for fit in fits)


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

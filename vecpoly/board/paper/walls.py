"""Where a bar leaves a slider block that is one link with it."""

from __future__ import annotations

from .bodies import Block

HEIGHT = 5.0  # mm: short side of a block


def holds(block: Block, at: complex) -> bool:
    """Whether a place lies within the block."""
    off = (at - block.at) * block.along.conjugate() / abs(block.along)
    return abs(off.real) < block.length / 2 and abs(off.imag) < HEIGHT / 2


def leaves(block: Block, start: complex, tip: complex) -> complex | None:
    """The place on a block's wall (mm) where the way from `start` to `tip` comes out of it; None where it does not."""
    turn = block.along / abs(block.along)
    p, q = ((z - block.at) * turn.conjugate() for z in (start, tip))
    span = _inside(p, q, complex(block.length, HEIGHT) / 2)
    return None if span is None or span[1] >= 1.0 else start + span[1] * (tip - start)


def _inside(p: complex, q: complex, half: complex) -> tuple[float, float] | None:
    """From which share to which the way p → q lies within a rectangle about the origin."""
    low, high = 0.0, 1.0
    for start, step, reach in ((p.real, (q - p).real, half.real), (p.imag, (q - p).imag, half.imag)):
        if abs(step) < 1e-9:
            if abs(start) >= reach:
                return None
            continue
        first, last = sorted(((-reach - start) / step, (reach - start) / step))
        low, high = max(low, first), min(high, last)
    return (low, high) if low < high else None

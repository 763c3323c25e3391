"""What is asked of a random linkage: everything that makes sense."""

from __future__ import annotations

from .sketch import FRAME, Sketch


def bar_asks(sketch: Sketch, link: str, p: str, c: str) -> None:
    """Relative motion of two pins of a bar."""
    if p in sketch.bodies[FRAME].at:
        sketch.finds += [f"an_{c}", f"at_{c}"]
    else:
        sketch.finds += [f"v_{c}{p}", f"a_{c}{p}", f"an_{c}{p}", f"at_{c}{p}"]


def slide_asks(sketch: Sketch, point: str, upper: str, lower: str) -> None:
    """Relative motion of coincident points of two links that slide over each other."""
    if FRAME in (upper, lower) or not {upper, lower} <= set(sketch.bodies):
        return
    pair = f"{point}{upper}{point}{lower}"
    sketch.finds += [f"v_{pair}", f"a_{pair}", f"ak_{pair}", f"ar_{pair}"]


def motion_asks(sketch: Sketch) -> None:
    """Velocity and acceleration of every letter, ω and α of every link."""
    frame = sketch.bodies[FRAME].at
    letters = dict.fromkeys(p for name, body in sketch.bodies.items() if name != FRAME for p in body.at)
    sketch.finds += [f"{kind}_{p}" for p in letters if p not in frame for kind in ("v", "a")]
    sketch.finds += [f"{kind}_{name}" for name in sketch.bodies if name != FRAME for kind in ("omega", "alpha")]
    sketch.finds[:] = dict.fromkeys(sketch.finds)

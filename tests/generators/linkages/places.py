"""Further points of a link, in every form of the manual, and pins on links that are known."""

from __future__ import annotations

from .sketch import FRAME, NEAR, Body, Sketch, deg, mm, turned


def pin(sketch: Sketch, body: Body, *away: complex) -> str:
    """A letter of this body away from these places: one that is there (then a multiple joint, maybe), or a new one."""
    there = [p for p, at in body.at.items() if all(abs(at - other) > 2 * NEAR for other in away)]
    if there and sketch.chance(0.5):
        return sketch.one(there)
    return further(sketch, body, *away)


def further(sketch: Sketch, body: Body, *away: complex) -> str:
    """A new point of the body."""
    letter = sketch.letter()
    if body.name == FRAME:
        body.at[letter] = sketch.spot(*away, *body.at.values())
        return letter
    forms = [_by_guide] if body.through else []
    forms += [_by_ray] if len(body.at) > 1 else []
    assert forms, body
    while True:
        at, entry = forms[int(sketch.rng.integers(len(forms)))](sketch, body, letter)
        if all(abs(at - other) > NEAR for other in (*away, *body.at.values())):
            body.at[letter] = at
            body.entries.append(entry)
            return letter


def _by_ray(sketch: Sketch, body: Body, letter: str) -> tuple[complex, str]:
    """By lengths, offsets or an angle from the ray of two points."""
    x, y = (str(p) for p in sketch.rng.choice(list(body.at), 2, replace=False))
    base, way = body.at[x], (body.at[y] - body.at[x]) / abs(body.at[y] - body.at[x])
    t, h = sketch.between(-60, 160), sketch.offset()
    at, ray = base + way * complex(t, h), x + y
    match sketch.one(["offsets", "angle", "lengths"]):
        case "angle":
            return (
                at,
                f"{letter}: {{{x}{letter}: {mm(abs(at - base))}, angle: {deg(turned(at - base, way))} from {ray}}}",
            )
        case "lengths" if abs(h) > 5:
            lengths = f"{x}{letter}: {mm(abs(at - base))}, {letter}{y}: {mm(abs(at - body.at[y]))}"
            return at, f"{letter}: {{{lengths}, side: {'left' if h > 0 else 'right'} of {ray}}}"
    return at, f"{letter}: {{along: {ray}, at: {mm(t)}{_beside(sketch, h)}}}"


def _by_guide(sketch: Sketch, body: Body, letter: str) -> tuple[complex, str]:
    """By offsets or an angle from the link's own line."""
    t, h = sketch.between(-60, 160), sketch.offset()
    base, at = body.at[body.through], body.at[body.through] + body.way * complex(t, h)
    if sketch.chance(0.5):
        return (
            at,
            f"{letter}: {{{body.through}{letter}: {mm(abs(at - base))}, angle: "
            f"{deg(turned(at - base, body.way))} from line}}",
        )
    return at, f"{letter}: {{along: {sketch.one([body.through, 'line'])}, at: {mm(t)}{_beside(sketch, h)}}}"


def _beside(sketch: Sketch, left: float) -> str:
    if left == 0.0:
        return ""
    return f", left: {mm(left)}" if sketch.chance(0.5) else f", right: {mm(-left)}"

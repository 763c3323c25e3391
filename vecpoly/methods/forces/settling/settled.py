"""Successive approximation (逐步逼近) on scratch paper:
the sense of every reaction, and the friction couples of pins that enter moment equations.

A group solved by moments needs the friction couple ρR of each pin before R is known. Passes over the whole mechanism
give couples from couples; between two changes of sense that is a linear relation, so its secant hits the fixed point.
Where reactions change sides friction is raised in a few shares, so that they do so one after the other: near
self-locking two sets of senses may each agree with themselves, and the one that a smaller friction leads to is meant.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ....board.board import NO_LENGTH
from ....board.unseen import unseen
from ....errors import EquilibriumError, LockedError, NoSlipSenseError
from ....foundation.slotted import replace
from ....mechanism.groups.assur import Group, ends
from ....mechanism.model import Prismatic, Revolute
from ....plane import Reals, cross, dot, nominal
from ....plane.traced import bare
from ....words import Words
from ...desk import Desk
from ..acting import Acting
from ..couples import pin_couples
from ..state import Statics
from .branch import CLOSE, Reached, bearing_nothing, determinant, foreseen, is_far, is_past_pole
from .secant import Couples, gap, secant
from .trial import on_trial, tried

Walk = Callable[[Statics], None]
Further = Callable[[Statics], dict[tuple[str, str], Reals]]
ROUNDS = 30  # for each share of the friction
SHARE = 0.25  # of the friction at a time
ONCE = 1  # with all of it at once: where every reaction keeps the side on which it presses without friction
FINEST = 0.01
LEAST = 1e-3  # the same, where none settles: a little of the friction farther on a reaction may have changed sides
KINK = 1e-4  # the same, where det(1 − G) leaps to the other sign, or a reaction leaps: whether they go on without
NEAR = 1e-3  # the same, where what side every reaction takes is told
NUDGE = 1e-7  # of the largest couple: by how much one is changed to see what the others do
SETTLED = 1e-12  # change of the couples between two rounds, of the largest couple


def settled(
    ideal: Statics, groups: tuple[Group, ...], walk: Walk, further: Further
) -> tuple[Statics, dict[tuple[str, str], Reals]]:
    """A pass with friction whose senses and pin couples reproduce themselves, and these couples.
    further: more couples than those of pins in groups.

    Raises LockedError where none is found: with this friction nothing moves.
    """
    start = Statics(
        desk=_on_fresh_paper(ideal),
        loads=ideal.loads,
        rubbing=True,
        ideal=ideal,
        inertia=ideal.inertia,
        inertia_couples=ideal.inertia_couples,
        hubs=ideal.hubs,
        own=ideal.own,
        pulls=ideal.pulls,
        balanced=ideal.balanced,
    )

    def rubbed(st: Statics) -> dict[tuple[str, str], Reals]:
        return pin_couples(st, groups) | further(st) | on_trial(st)

    couples: dict[tuple[str, str], Reals] = dict.fromkeys(pin_couples(ideal, groups), 0.0)
    couples |= further(ideal) | on_trial(ideal)  # from the first, so that moments solve the groups of hubs
    return _raised(start, ideal, rubbed, walk, couples)


def _raised(
    start: Statics, ideal: Statics, rubbed: Further, walk: Walk, couples: dict[tuple[str, str], Reals]
) -> tuple[Statics, dict[tuple[str, str], Reals]]:
    """All of the friction at once where nothing changes sides, nor any reaction by much; else share by share, smaller
    ones where a share binds that may not with the senses and couples of a little less."""
    guide, path = ideal, [Reached(share=0.0, couples=couples)]
    stride = SHARE if ideal.by_moments or ideal.hubs or ideal.balanced else 1.0
    while (last := path[-1]).share < 1.0:
        share = min(last.share + stride, 1.0)
        try:
            begun = replace(start, ideal=guide, share=share)
            rounds = ROUNDS if stride <= SHARE else ONCE
            found, couples, answer = _fixed(begun, rubbed, walk, foreseen(path, share), rounds)
        except NoSlipSenseError:
            raise
        except EquilibriumError:
            if stride < LEAST:
                raise
            stride = min(stride / 2, SHARE)
            continue
        answering = last.answering if not answer.size else _answering(last, found, rubbed, walk, couples, answer)
        turned, far = answering * last.side <= 0, is_far(found, guide)
        leapt = turned and not far and not is_past_pole(last.answering, answering)
        if (turned or far) and stride >= (FINEST if turned and not leapt else KINK):
            stride = min(stride / 2, SHARE)  # too far to be sure that it is the same equilibrium, grown
            continue
        if turned and (far or (leapt and is_far(found, guide, CLOSE))):
            raise _locked(start)
        guide, stride = found, min(2 * stride, SHARE) if stride < SHARE else stride
        side = -last.side if turned else last.side
        path.append(Reached(share=share, couples=couples, answering=answering, side=side))
    return guide, path[-1].couples


def _answering(
    last: Reached, found: Statics, rubbed: Further, walk: Walk, couples: Couples, answer: np.ndarray
) -> float:
    """det(1 − G) of how the couples answer; where it has another sign than before, without the friction of joints that
    bear nothing: the side on which it would act is anyone's guess, and each gives another answer."""
    told = determinant(answer)
    if told * last.side <= 0 and (bare := bearing_nothing(found)):
        return determinant(_slope(replace(found, bare=bare), found, rubbed, walk, couples, couples))
    return told


def _fixed(
    start: Statics, rubbed: Further, walk: Walk, couples: Couples, rounds: int
) -> tuple[Statics, dict[tuple[str, str], Reals], np.ndarray]:
    """The fixed point at one share of the friction, and how the couples that come out answer those put in.

    A group that moments had to solve once stays with them: else lines of action, which need no couples, and moments
    would take turns.
    """
    guide, slope, last, near = start.ideal, None, np.inf, NEAR
    assert guide is not None
    for _ in range(rounds):
        st = _pass(start, guide, couples, walk)
        start = replace(start, by_moments=start.by_moments | st.by_moments)
        after = rubbed(st)
        if after.keys() != couples.keys():
            # friction wakes loads on a link that only passed a force on: now moments solve its group, near to where
            # lines of action led, for with other couples another equilibrium may settle
            before = rubbed(replace(guide, by_moments=st.by_moments, share=start.share))
            couples = {key: couples.get(key, before.get(key, 0.0)) for key in after}
            guide, slope, last = guide if before.keys() >= after.keys() else st, None, np.inf
            continue
        same, moved = _same_senses(st, guide), gap(couples, after)
        if same and moved < SETTLED:
            return st, after, np.zeros((0, 0)) if slope is None else slope
        if not same and moved < near:  # settled with these senses: now those that came out otherwise change sides
            guide, slope, last, near = st, None, np.inf, max(moved / 10, SETTLED)  # the next time nearer to it
            continue
        if slope is None or moved > last / 10:  # the first secant, or one that has grown old
            slope = _slope(start, guide, rubbed, walk, couples, after) if couples else np.zeros((0, 0))
        last = moved
        try:
            couples = secant(couples, after, slope)
        except np.linalg.LinAlgError:
            break
    raise _locked(start)


def _locked(start: Statics) -> LockedError:
    return LockedError(
        Words(
            f"考虑摩擦时各反力不断换侧，平衡不能确定：机构在此位置对 {start.unknown.name} 自锁；请减小 f 或 ρ",
            "with friction no equilibrium settles, the reactions keep changing sides: the mechanism is locked "
            f"for {start.unknown.name} in this position, lower f or ρ",
        )
    )


def _on_fresh_paper(st: Statics) -> Desk:
    """The desk with paper for one pass, at which nobody looks."""
    desk = replace(st.desk, board=unseen(st.board))
    desk.board.step(Words.same(""))
    return desk


def _pass(start: Statics, guide: Statics, couples: Couples, walk: Walk) -> Statics:
    st = replace(
        start,
        desk=_on_fresh_paper(start),
        ideal=guide,
        couples=dict(couples),
        acting={},
        by_moments=set(start.by_moments),
    )
    st.balance = tried(st, couples)
    walk(st)
    return st


def _same_senses(st: Statics, guide: Statics) -> bool:
    """Whether every reaction has the sense that the guide foretold, and its friction opposes the motion as assumed;
    of one that was zero there it foretold none."""
    pairs = [(key, guide.push(*key), found) for key, found in st.acting.items()]
    return all(_kept(before, found) and _opposed(st, key, before, found) for key, before, found in pairs)


def _kept(before: Acting | None, found: Acting) -> bool:
    if before is None or abs(nominal(before.vector)) < NO_LENGTH:
        return abs(float(nominal(np.abs(found.vector)))) < NO_LENGTH
    return float(nominal(dot(found.vector, before.vector))) >= 0


def _opposed(st: Statics, key: tuple[str, str], before: Acting | None, found: Acting) -> bool:
    """Whether a reaction turns about its pin against the motion, and presses in its slide on the side on which its
    friction was laid: steep as it may lean, its direction alone does not tell the side."""
    by, on = key
    if abs(float(nominal(np.abs(found.vector)))) < NO_LENGTH:
        return True
    for joint in (one for one in st.mech.joints if set(ends(one)) == {by, on}):
        if isinstance(joint, Prismatic) and st.phi(joint):
            normal = 1j * st.desk.guide_line(joint).along
            return before is None or float(nominal(dot(found.vector, normal) * dot(before.vector, normal))) >= 0
        if isinstance(joint, Revolute) and found.tangent and st.rho(joint.point):
            return float(nominal(cross(found.at - st.desk.at[joint.point], found.vector))) * found.tangent >= 0
    return True


def _slope(start: Statics, guide: Statics, rubbed: Further, walk: Walk, couples: Couples, after: Couples) -> np.ndarray:
    """How the couples that come out change with those put in: a further pass for each, nominal hand; one pass for all,
    as if by several hands, where nobody repeats the drawing.

    after: those that come out of `couples`; all with the senses of the guide, for the secant belongs to these.
    """
    base = {key: float(nominal(c)) for key, c in after.items()}
    stride = (max([abs(c) for c in base.values()]) or 1.0) * NUDGE

    def rise(moved: Couples) -> list[np.ndarray]:
        found = rubbed(_pass(start, guide, moved, walk))
        return [(np.asarray(bare(found.get(key, c))) - c) / stride for key, c in base.items()]

    if any(np.ndim(bare(one)) for one in (*couples.values(), *after.values(), *start.desk.at.values())):
        apart = [rise({**couples, key: couples[key] + stride}) for key in couples]
        return np.array([[nominal(one) for one in column] for column in apart]).T
    nudges = stride * (1.0 + np.vstack([np.zeros(len(couples)), np.eye(len(couples))]))  # none is left at nothing
    together = rise({key: c + nudges[:, i] for i, (key, c) in enumerate(couples.items())})
    return np.stack([each[1:] - each[0] for each in (np.broadcast_to(one, len(nudges)) for one in together)])

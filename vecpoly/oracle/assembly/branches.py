"""Which of two assemblies: the statements of the problem, read on both at the problem's own position."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import BranchError, DeadPointError, UnknownNameError
from ...foundation.slotted import replace
from ...mechanism.assembly.branch import margin, nearer, not_yet, opposite
from ...mechanism.assembly.four_bar import folded_corner, fourth_corner
from ...mechanism.assembly.statements import Form, Shaped
from ...mechanism.model import Mechanism, Revolute, Statement
from ...words import Words
from ..closed.cammed import curvature_centre
from ..closed.dyads import Hinged, Swinging
from ..closed.parallel import folded, parallel
from ..iterated.driven import drives_in
from ..iterated.driven_assemblies import among
from ..iterated.newton import Newton
from ..run import Run
from ..state import Bodies
from ..steps import Step
from .advice import Places, advice, is_hinged


def places(mech: Mechanism, bodies: Bodies) -> Places:
    """Place of every letter on the solved links, at the last position."""
    found = {
        point: complex(body.point(local)[-1])
        for name, body in bodies.items()
        for point, local in mech.link(name).points.items()
    }
    wandering = {cam.centre: complex(curvature_centre(cam, bodies)[-1]) for cam in mech.cams if cam.link in bodies}
    return found | wandering


def check_letters(mech: Mechanism) -> None:
    """UnknownNameError where a statement names a letter that no link carries."""
    letters = {point for link in mech.links for point in link.points} | set(mech.frame)
    for statement in mech.branches:
        for letter in statement.letters:
            if letter not in letters:
                raise UnknownNameError(
                    Words(
                        f"“{statement}”中的点 {letter} 不存在；已有：{', '.join(sorted(letters))}",
                        f"'{statement}' names the unknown point {letter}; known: {', '.join(sorted(letters))}",
                    )
                )


def choose(mech: Mechanism, step: Step, bodies: Bodies, run: Run) -> Step:
    """The step with the sign of the assembly that the statements describe.

    Raises BranchError where they describe neither or do not tell the two apart,
    DeadPointError where the two coincide.
    """
    if isinstance(step, Newton) and drives_in(step.rows):
        return among(mech, step, bodies, run)
    before = places(mech, bodies)
    figure = _parallelogram(mech, step)
    if figure is not None and _is_said(mech, figure):
        return parallel(mech, step.group, figure.corners[0])
    options = [_signed(step, sign) for sign in ((1.0, -1.0) if step.two else (1.0,))]
    after = [before | places(mech, option.place(bodies, run)) for option in options]
    where = run.text(float(run.q[-1]))
    _check_dead_point(mech, step, after, where)
    told = [s for s in mech.branches if set(s.letters) <= set(after[0]) and not set(s.letters) <= set(before)]
    sure = 1e-9 * mech.scale
    fits = [all(margin(s, at) > sure for s in told) for at in after]
    if fits.count(True) == 1:
        return _figured(mech, options[fits.index(True)], figure, after[fits.index(True)])
    if all(fits) and step.two and not isinstance(step, Swinging):
        near = nearer(mech.guesses, after[0], after[1], 1e-6 * mech.scale)
        if near is not None:
            return _figured(mech, options[near], figure, after[near])
    if not any(fits):
        raise BranchError(_neither(step, told, where) + advice(mech, step, before, after))
    if isinstance(step, Swinging):
        return _ahead(step, bodies) or _guessed(mech, options, after, where)
    early = not_yet(mech.branches, step.joint, after[0])
    raise BranchError(_either(step, early) + advice(mech, step, before, after))


def _check_dead_point(mech: Mechanism, step: Step, after: Sequence[Places], where: str) -> None:
    """DeadPointError where the two assemblies of a group that is closed in a hinge coincide."""
    if is_hinged(step) and step.two and abs(after[0][step.joint] - after[1][step.joint]) < 1e-7 * mech.scale:
        raise DeadPointError(
            Words(
                f"原动件位于 {where} 时构件 {step.group.told.zh} 处于死点位置，两种装配方式重合，无法区分；"
                "请另取原动件位置",
                f"links {step.group.told.en} are at a dead point where the drive stands at {where}: their two "
                "assemblies coincide and cannot be told apart; choose another position of the drive",
            )
        )


def _neither(step: Step, told: Sequence[Statement], where: str) -> Words:
    """No assembly is as the statements say."""
    said = [f"'{s}'" for s in told]
    return Words(
        f"原动件位于 {where} 时，构件 {step.group.told.zh} 的两种装配方式都不满足 {'、'.join(said)}",
        f"links {step.group.told.en}: neither assembly fulfils {' and '.join(said)} where the drive stands at {where}",
    )


def _either(step: Step, early: Words | None) -> Words:
    """Nothing tells which assembly is meant; early: why what is said does not."""
    told = Words(
        f"构件 {step.group.told.zh} 在运动副 {step.joint} 处有两种装配方式",
        f"links {step.group.told.en} can be assembled in two ways at joint {step.joint}",
    )
    return told if early is None else told + Words("；", "; ") + early


def _signed(step: Step, sign: float) -> Step:
    """The step with this sign; one that has it is kept with the assembly that it found."""
    return step if step.sign == sign else replace(step, sign=sign)


def confirm(mech: Mechanism, bodies: Bodies, run: Run) -> None:
    """BranchError for a statement that is not so in the finished assembly: the drive or the data decide otherwise."""
    at, where = places(mech, bodies), run.text(float(run.q[-1]))
    for statement in mech.branches:
        gap = margin(statement, at)
        if gap < -1e-9 * mech.scale:
            held = opposite(statement)
            raise BranchError(
                Words(
                    f"'{statement}' 与其余数据矛盾：原动件位于 {where} 时，由其余数据得 '{held}'，"
                    f"相距 {-1e3 * gap:.4g} mm；请删去或改正其一",
                    f"'{statement}' contradicts the other data: where the drive stands at {where}, they "
                    f"make it '{held}', by {-1e3 * gap:.4g} mm; leave it out, or correct either",
                ),
                code="branch contradicts",
                numbers={"gap": gap},
            )


def _figured(mech: Mechanism, step: Step, figure: Shaped | None, at: Places) -> Step:
    """The step itself, or where it is a parallelogram or a folded kite the
    step that stays one through its change points."""
    if figure is not None and margin(figure, at) > 0:
        return parallel(mech, step.group, figure.corners[0])
    if (
        isinstance(step, Hinged)
        and step.group.dyad is not None
        and (corner := folded_corner(mech, step.group.dyad)) is not None
    ):
        return folded(mech, step.group, corner) if abs(at[step.joint] - at[corner]) < 1e-7 * mech.scale else step
    return step


def _parallelogram(mech: Mechanism, step: Step) -> Shaped | None:
    """What is said of a dyad that can be half of a parallelogram."""
    dyad = step.group.dyad
    if not isinstance(step, Hinged) or dyad is None or (corner := fourth_corner(mech, dyad)) is None:
        return None
    b, d = (joint.point for joint in (dyad.outer_j, dyad.outer_k) if isinstance(joint, Revolute))
    return Shaped(corners=(corner, b, step.joint, d), form=Form.PARALLELOGRAM)


def _is_said(mech: Mechanism, shape: Shaped) -> bool:
    return any(
        isinstance(s, Shaped) and s.form is shape.form and set(s.letters) == set(shape.letters) for s in mech.branches
    )


def _ahead(step: Swinging, bodies: Bodies) -> Swinging | None:
    """The block ahead of the guide's letter along the guide's positive direction;
    None where it is so in both directions, or in none."""
    options = [replace(step, sign=sign) for sign in (1.0, -1.0)]
    here, there = step.ends(bodies)
    forward = [option for option in options if option.sign * option.reach(there - here)[-1] + option.shift > 0]
    return forward[0] if len(forward) == 1 else None


def _guessed(mech: Mechanism, options: Sequence[Step], after: Sequence[Places], where: str) -> Step:
    """The direction in which the guide's letters lie nearer to the rough places;
    BranchError where these do not tell."""
    near = nearer(mech.guesses, after[0], after[1], 1e-6 * mech.scale) if len(after) == 2 else None
    if near is None:
        step = options[0]
        assert isinstance(step, Swinging)
        raise BranchError(
            Words(
                f"原动件位于 {where} 时，构件 {step.guide} 的导路（其上滑块 {step.block}）有两个方向可装配；"
                "请在 branch 中写出该组某点在哪一侧，或以 guesses 给出其大致位置",
                f"the guide of link {step.guide}, on which link {step.block} slides, can point either way "
                f"where the drive stands at {where}; say in 'branch' on which side a point of these two "
                "links lies, or give its rough place as guesses",
            ),
            code="branch-missing",
        )
    return options[near]

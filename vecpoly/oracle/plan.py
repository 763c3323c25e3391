"""The steps that solve a mechanism, group by group: every link at every position of the drive."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import AssemblyError
from ..foundation.slotted import replace
from ..mechanism.model import FRAME, Mechanism
from ..words import Words
from .assembly.across import across
from .assembly.feasible import Closes, Ranges, Spans, alone, refusal, scan, spans
from .closed.dyads import Hinged, Swinging
from .drive import Driver
from .run import STEP, Run, track
from .state import Body, Reals, at_rest
from .steps import Step, is_followed

TIGHT = 1e-5  # square of the sine of a folded dyad below which its change points are looked for


@dataclass(frozen=True, slots=True)
class Plan:
    """Drives against the frame and steps in order of solution. Build it with `planning.plan_for`."""

    mech: Mechanism
    drivers: tuple[Driver, ...]
    steps: tuple[Step, ...] = ()
    followed: bool = False  # angles are followed along a path from the own position

    def start(self, asked: Reals, strict: bool) -> tuple[Run, dict[str, Body]]:
        """The run over these positions, with frame and driving links in place."""
        if not np.isfinite(asked).all():
            raise AssemblyError(Words("原动件的位置不是有限的数", "a position of the drive is not a finite number"))
        drive = self.mech.drive
        run = Run(asked, strict, "mm" if drive.slide else "deg", zero=drive.lead)
        if self.followed:
            path, q = track(drive.position, STEP * (self.mech.scale if drive.slide else 2 * np.pi), asked)
            run = replace(run, q=q, track=path)
        held = {
            one.drive.link: one.body(run.q if one.drive is drive else np.full(1, one.drive.position))
            for one in self.drivers
        }
        return run, {FRAME: at_rest(), **held}

    def bodies(self, asked: Reals, order: int = 2, strict: bool = True) -> dict[str, Body]:
        """Every link at these positions of the drive (rad or m); rates where the order asks for them.

        Raises AssemblyError or DeadPointError at the first failing position, or gives NaN where not strict.
        """
        drive = self.mech.drive
        changes = [
            step.changes for step in self.steps if isinstance(step, Hinged | Swinging) and step.changes is not None
        ]
        if not changes:
            return self._bodies(asked, order, strict)
        found = across(changes, asked, drive, self.mech.scale, lambda q: self._bodies(q, order, strict))
        return found | {one.drive.link: one.body(asked) for one in self.drivers if one.drive is drive}

    def _bodies(self, asked: Reals, order: int, strict: bool) -> dict[str, Body]:
        """The same, as each position alone gives it: without digits beside a change point."""
        with quiet():
            run, bodies = self.start(asked, strict)
            for step in self.steps:
                bodies |= self.placed(step, bodies, run)
            run, bodies = run.arrived(bodies)
            if order > 0:
                for step in self.steps:
                    bodies |= step.move(bodies, run)
        return bodies

    def placed(self, step: Step, bodies: dict[str, Body], run: Run) -> dict[str, Body]:
        """The step's links; AssemblyError where they do not close at a position asked for."""
        new = step.place(bodies, run)
        last = new[step.group.links[-1]]  # it shows every gap: both links of a dyad meet in it
        total = last.unit.sum() + last.at.sum()
        if run.strict and total != total:
            self._refuse(step, bodies, new, run)
        return new

    def _refuse(self, step: Step, bodies: dict[str, Body], new: dict[str, Body], run: Run) -> None:
        """Raise for the first position asked for that does not close."""
        open_ = np.zeros(run.q.shape, bool)
        for body in new.values():
            open_ |= np.isnan(body.unit) | np.isnan(body.at)
        if open_[run.asked :].any():
            first = run.first(open_)
            gap = np.broadcast_to(step.miss(bodies, run), run.q.shape)[first]
            here, closes = float(run.q[first]), self._upto(step).closes()
            raise refusal(
                step,
                run.text(here),
                float(gap),
                self.ranges(step),
                alone=alone(closes, here, self.mech.scale),
                carried=self.followed and not bool(closes(np.array([self.mech.drive.position]))[0]),
            )

    def ranges(self, step: Step | None = None) -> Ranges:
        """Ranges of the drive in which everything closes up to and including this step (all of them: None)."""
        plan = self if step is None else self._upto(step)
        return scan(plan.closes(), self.mech.drive, self.mech.scale, followed=plan.followed)

    def _upto(self, step: Step) -> Plan:
        """The plan that ends with this step."""
        names = [known.group for known in self.steps]
        return replace(
            self, steps=(*self.steps[: names.index(step.group) if step.group in names else len(names)], step)
        )

    def spans(self) -> Spans:
        """Ranges of the drive (rad, or m) in which everything closes."""
        return spans(self.closes(), self.mech.drive, self.mech.scale, followed=self.followed)

    def fold(self, step: Hinged | Swinging, q: Reals) -> Reals:
        """How far a further step is from a change point at these positions."""
        with quiet():
            run, bodies = self.start(q, strict=False)
            for known in self.steps:
                bodies |= known.place(bodies, run)
            found = step.fold(bodies)
            return found if found.shape == q.shape else np.broadcast_to(found, q.shape)

    @property
    def is_tight(self) -> bool:
        """Whether a dyad stands so near a change point at the own position that few digits of its rates are left."""
        own = np.array([self.mech.drive.position])
        return any(
            isinstance(step, Hinged | Swinging) and step.two and bool(self._before(i).fold(step, own)[-1] < TIGHT)
            for i, step in enumerate(self.steps)
            if not any(map(is_followed, self.steps[: i + 1]))
        )

    @property
    def has_changes(self) -> bool:
        """Whether a dyad has change points (known of a plan for all positions alone)."""
        return any(isinstance(step, Hinged | Swinging) and step.changes is not None for step in self.steps)

    def _before(self, i: int) -> Plan:
        """The steps before the i-th, none of which needs a path."""
        return replace(self, steps=self.steps[:i], followed=False)

    def closes(self) -> Closes:
        """Whether everything closes, as a function of the drive's positions."""

        def closes(q: Reals) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
            bodies = self._bodies(q, 0, False)
            sound = np.ones(q.shape, bool)
            for body in bodies.values():
                sound &= ~np.isnan(body.at)
                if body.turn is None:  # a followed angle is lost with the path to it, not with its own position
                    sound &= ~np.isnan(body.unit)
            return sound

        return closes


def quiet() -> np.errstate:
    """Where positions that do not assemble, or have no digits, come out as NaN without a warning."""
    return np.errstate(invalid="ignore", divide="ignore", over="ignore")

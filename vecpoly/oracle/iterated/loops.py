"""The loop equations of a group as real numbers, their Jacobian, and Newton's iteration on them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism
from ..state import Bodies, Body, Points
from .driven import Driven, less_asked
from .rows import Row
from .standing import Standing
from .watch import PATIENCE, Watch

States = NDArray[np.float64]  # positions × links × (x, y, φ), or positions × 3 links
ITERATIONS = 40


@dataclass(frozen=True, slots=True)
class Loops:
    """The equations of one group; `mech` serves the first guess."""

    mech: Mechanism
    group: Group
    rows: tuple[Row | Driven, ...]  # those of drives last
    stands: tuple[Standing, ...] = ()  # in the place of no slip at the own position
    size: float = field(init=False)  # the mechanism's (m)

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", self.mech.scale)

    def solve(self, seed: States, known: Bodies, ref: States | None, ago: Bodies, patience: int = PATIENCE) -> States:
        """Newton's iteration; without reference (at the own position) what is
        told of the links' places stands for no slip. NaN where it fails."""
        states, loose, left = seed.copy(), ref is None, np.arange(len(seed))
        past, here, watch = (
            {**ago, **self.bodies_at(seed if ref is None else ref)},
            {**known},
            Watch(len(seed), self.size, patience),
        )
        for _ in range(ITERATIONS):
            now = {**here, **self.bodies_at(states[left])}
            gap = self.stack(
                [r.gap(now[r.a], now[r.b], past[r.a], past[r.b]) for r in self.rows], len(left), now if loose else None
            )
            less_asked(gap, self.rows, here)
            step = self.linear(self.jacobian(now, loose), gap, loose)
            reach = np.abs(step[..., 2]).max(axis=1)
            states[left] += step * np.minimum(1.0, 0.5 / np.maximum(reach, 1e-300))[:, None, None]
            more = watch.goes_on(left, np.abs(gap).max(axis=1), np.abs(step).max(axis=(1, 2)))
            if not more.any():
                break
            if not more.all():
                pick, left = np.flatnonzero(more), left[more]
                here, past = ({name: body.take(pick) for name, body in bodies.items()} for bodies in (here, past))
        states[watch.lost] = np.nan
        return states

    def stack(self, gaps: list[Points], count: int, loose: Bodies | None = None) -> States:
        """Complex gaps as real equations: positions × 3k. loose: the links, where starts stand for no slip."""
        stacked, line, stands = np.zeros((count, 3 * len(self.group.links))), 0, iter(self.stands)
        for r, gap in zip(self.rows, gaps, strict=True):
            if loose is None or not r.rolls:
                stacked[:, line] = gap.real
            elif (stand := next(stands, None)) is not None:
                stacked[:, line] = self.size * stand.gap(loose)
            if not r.held:
                stacked[:, line + 1] = gap.imag
            line += 1 if r.held else 2
        return stacked

    def jacobian(self, now: Bodies, loose: bool = False) -> States:
        """∂g/∂(x, y, scale φ): positions × 3k × 3k."""
        links = self.group.links
        count = len(now[links[0]].unit)
        matrix = np.zeros((count, 3 * len(links), 3 * len(links)))
        line, stands = 0, iter(self.stands)
        for r in self.rows:
            if loose and r.rolls and (stand := next(stands, None)) is not None:
                matrix[:, line, :] = self.size * stand.jac(now, links).reshape(count, -1)
            for name, block in zip((r.a, r.b), r.jac(now[r.a], now[r.b]), strict=True):
                if name in links:
                    column = slice(3 * links.index(name), 3 * links.index(name) + 3)
                    if not (loose and r.rolls):
                        matrix[:, line, column] = block.real
                    if not r.held:
                        matrix[:, line + 1, column] = block.imag
            line += 1 if r.held else 2
        matrix[:, :, 2::3] /= self.size
        return matrix

    def linear(self, matrix: States, right: States, loose: bool = False) -> States:
        """-J⁻¹ g as positions × links × 3."""
        try:
            if loose:
                raise np.linalg.LinAlgError
            solved = np.linalg.solve(matrix, -right[..., None])
        except np.linalg.LinAlgError:
            solved = np.linalg.pinv(matrix) @ -right[..., None]
        steps: States = np.reshape(solved, (len(right), -1, 3)).astype(np.float64)
        steps[..., 2] /= self.size
        return steps

    def bodies_at(self, states: States) -> dict[str, Body]:
        """The links where x, y, φ are these."""
        return {
            name: Body(0j, states[:, i, 0] + 1j * states[:, i, 1], np.exp(1j * states[:, i, 2]), states[:, i, 2])
            for i, name in enumerate(self.group.links)
        }

    def moving(self, bodies: Mapping[str, Body], rates: States, bends: States) -> dict[str, Body]:
        """The links with their velocities and accelerations."""
        return {name: with_rates(bodies[name], rates[:, i], bends[:, i]) for i, name in enumerate(self.group.links)}


def with_rates(body: Body, rate: States, bend: States) -> Body:
    """The body with its velocity and its acceleration (x, y, φ of each)."""
    return body.moving(rate[:, 0] + 1j * rate[:, 1], rate[:, 2], bend[:, 0] + 1j * bend[:, 1], bend[:, 2])

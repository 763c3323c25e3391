"""Groups of class III and higher, and gear trains: Newton on all loop equations of the group at once.

J x' = -g'(known), J x'' = -g''(known, x'), the right-hand sides being analytic. The path from the problem's own
position to all others is walked in small strides, so that the assembly found there is kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism
from ..closed.off_centre import places
from ..run import Run, Track
from ..state import Bodies, Body, Points, Reals
from .assemblies import chosen, distances, is_guessed
from .driven import Driven, asked_of, drives_in, less_asked
from .guess import first_guess
from .rows import Row
from .scatter import distinct, random_starts, scattered
from .standing import Standing, carriers
from .watch import PATIENCE, Watch

States = NDArray[np.float64]  # positions × links × (x, y, φ), or positions × 3 links
ITERATIONS = 40
EXACT = 1e-9  # of the mechanism's size: guesses nearer to an assembly than this are one


@dataclass(frozen=True, slots=True)
class Newton:
    """The step of one group; `mech` serves the first guess."""

    mech: Mechanism
    group: Group
    rows: tuple[Row | Driven, ...]  # those of drives last
    stands: tuple[Standing, ...] = ()  # in the place of no slip at the own position
    sign: float = 1.0
    two: bool = False
    joint: str = field(default="", kw_only=True)
    size: float = field(init=False)  # the mechanism's (m)
    walked: dict[int, States] = field(
        default_factory=dict, compare=False, repr=False, init=False
    )  # strides from the own position → states found
    met: list[States] = field(
        default_factory=list, compare=False, repr=False, init=False
    )  # every assembly at the own position, once sought

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", self.mech.scale)

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """Walk the path from the own position outwards, then solve all positions asked for at once."""
        assert run.track is not None
        track, known = run.track, self.known(bodies, run.track, run.q)
        states = np.full((len(run.q), len(self.group.links), 3), np.nan)
        here = {name: body.take(np.array([track.own])) for name, body in known.items()}
        if 0 not in self.walked:
            own = {name: body.take(np.array([track.own])) for name, body in bodies.items()}
            self.walked[0] = self._own(here, own)
        states[track.own] = self.walked[0]
        for way in (1, -1):
            self._walk(states, known, track, way)
        self._fill(states, known, run.q, track)
        return self._bodies(states)

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """Velocities, then accelerations, from one Jacobian."""
        still = {**bodies, **{n: _rates(bodies[n], np.zeros((1, 3)), np.zeros((1, 3))) for n in self.group.links}}
        jacobian = self._jacobian(still)
        blank = np.eye(jacobian.shape[1])
        lost: NDArray[np.bool_] = np.asarray(np.isnan(jacobian).any(axis=(1, 2)))
        jacobian = np.where(lost[:, None, None], blank, jacobian)
        lost |= np.isnan(run.alive(1 / np.linalg.cond(jacobian), 1.0, self.group.links))
        jacobian = np.where(lost[:, None, None], blank, jacobian)
        rates = self._linear(jacobian, self._stack([r.rate(still[r.a], still[r.b]) for r in self.rows], len(run.q)))
        rates[lost] = np.nan
        moved = {**bodies, **self._moving(bodies, rates, np.zeros_like(rates))}
        bends = self._linear(jacobian, self._stack([r.accel(moved[r.a], moved[r.b]) for r in self.rows], len(run.q)))
        return self._moving(bodies, rates, bends)

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """No gap to tell: the loops do not close at all."""
        return np.full(1, np.nan)

    def assemblies(self, here: Bodies) -> States:
        """Every assembly of a group with a drive inside, the known links (and the drive) being in their own positions;
        sought once."""
        if not self.met:
            seeds = random_starts(self.mech, len(self.group.links))
            self.met.append(distinct(self._solve(seeds, here, seeds, here, ITERATIONS), self.size))
        return self.met[0]

    def _own(self, here: Bodies, known: Bodies) -> NDArray[np.float64]:
        """The assembly at the own position: nearest to the guesses; with a drive inside any, until one is chosen."""
        if not drives_in(self.rows):
            about = places(self.mech, self.group, here, self.sign) if self.two else {}
            return self._nearest(first_guess(self.mech, self.group, here, about), here, known)
        found = self.assemblies(here)
        return np.asarray(found[0]) if len(found) else np.full((len(self.group.links), 3), np.nan)

    def _nearest(self, guess: States, here: Bodies, known: Bodies) -> NDArray[np.float64]:
        """Of the assemblies that Newton reaches from about the guess, the one that is meant."""
        if any(r.rolls for r in self.rows):
            return np.asarray(self._solve(guess, here, None, here, ITERATIONS)[0])
        exact = is_guessed(self.mech, self.group) and self._exact(guess, here)
        seeds = (
            guess
            if exact
            else np.concatenate(
                [guess, scattered(guess, self.size, 0.15 if is_guessed(self.mech, self.group) else 0.5)]
            )
        )
        return chosen(self.mech, self.group, self._solve(seeds, here, seeds, here, ITERATIONS), known)

    def _exact(self, guess: States, here: Bodies) -> bool:
        """Whether the guesses are an assembly: then none lies nearer to them."""
        told = {*self.mech.guesses, *(p for name in here for p in self.mech.link(name).points)}
        whole = all(len(told & set(self.mech.link(name).points)) > 1 for name in self.group.links)
        return whole and bool(
            distances(self.mech, self.group, self._solve(guess, here, guess, here))[0] < EXACT * self.size
        )

    def known(self, bodies: Bodies, track: Track | None, q: Reals) -> dict[str, Body]:
        """The drives' positions, and the parents; under a rolling joint with their angles followed."""
        names = {name for r in self.rows for name in (r.a, r.b)} - set(self.group.links)
        names |= {name for stand in self.stands for name in carriers(stand) if name in bodies}
        drives = asked_of(self.rows, q)
        if not any(r.rolls for r in self.rows):
            return {**drives, **{name: bodies[name] for name in names}}
        followed = {**drives}
        for name in names:
            body = bodies[name]
            turn = body.turn
            if turn is None:
                turn = track.follow(np.angle(body.unit)) if track and len(body.unit) > 1 else np.angle(body.unit)
            followed[name] = Body(body.local, body.at, body.unit, turn)
        return followed

    def _walk(self, states: States, known: Bodies, track: Track, way: int) -> None:
        """Fill the path in one direction; what lies beyond a position that fails stays NaN."""
        last = before = track.own
        while 0 <= last + way < track.size:
            index = last + way
            if index - track.own in self.walked:
                states[index] = self.walked[index - track.own]
                if np.isnan(states[index]).any():
                    return
                before, last = last, index
                continue
            seed = 2 * states[last] - states[before] if before != last else states[last]
            here = {name: body.take(np.array([index])) for name, body in known.items()}
            if not all(np.isfinite(body.at + body.unit).all() for body in here.values()):
                return
            ago = {name: body.take(np.array([last])) for name, body in known.items()}
            states[index] = self.walked[index - track.own] = self._solve(seed[None], here, states[last][None], ago)[0]
            if np.isnan(states[index]).any():
                return
            before, last = last, index

    def _fill(self, states: States, known: Bodies, q: Reals, track: Track) -> None:
        """The positions asked for, each started from the path position before it."""
        asked, path = slice(track.size, None), states[: track.size]
        reach = (q[asked] - q[track.near]) / ((q[1] - q[0]) if track.size > 1 else 1.0)
        ahead = np.clip(track.near + np.sign(reach).astype(np.intp), 0, track.size - 1)
        seed = path[track.near] + np.abs(reach)[:, None, None] * np.nan_to_num(path[ahead] - path[track.near])
        here = {name: body.take(asked) for name, body in known.items()}
        ago = {name: body.take(track.near) for name, body in known.items()}
        good = ~np.isnan(seed).any(axis=(1, 2))
        for body in here.values():
            good &= np.isfinite(body.at) & np.isfinite(body.unit)
        found = np.full_like(seed, np.nan)
        if good.any():
            pick = np.flatnonzero(good)
            here = {name: body.take(pick) for name, body in here.items()}
            ago = {name: body.take(pick) for name, body in ago.items()}
            found[good] = self._solve(seed[good], here, path[track.near][good], ago)
        states[asked] = found

    def _solve(self, seed: States, known: Bodies, ref: States | None, ago: Bodies, patience: int = PATIENCE) -> States:
        """Newton's iteration; without reference (at the own position) what is told of the links' places stands for no
        slip. NaN where it fails."""
        states, loose, left = seed.copy(), ref is None, np.arange(len(seed))
        past, here, watch = (
            {**ago, **self._bodies(seed if ref is None else ref)},
            {**known},
            Watch(len(seed), self.size, patience),
        )
        for _ in range(ITERATIONS):
            now = {**here, **self._bodies(states[left])}
            gap = self._stack(
                [r.gap(now[r.a], now[r.b], past[r.a], past[r.b]) for r in self.rows], len(left), now if loose else None
            )
            less_asked(gap, self.rows, here)
            step = self._linear(self._jacobian(now, loose), gap, loose)
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

    def _stack(self, gaps: list[Points], count: int, loose: Bodies | None = None) -> States:
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

    def _jacobian(self, now: Bodies, loose: bool = False) -> States:
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

    def _linear(self, matrix: States, right: States, loose: bool = False) -> States:
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

    def _bodies(self, states: States) -> dict[str, Body]:
        return {
            name: Body(0j, states[:, i, 0] + 1j * states[:, i, 1], np.exp(1j * states[:, i, 2]), states[:, i, 2])
            for i, name in enumerate(self.group.links)
        }

    def _moving(self, bodies: Mapping[str, Body], rates: States, bends: States) -> dict[str, Body]:
        return {name: _rates(bodies[name], rates[:, i], bends[:, i]) for i, name in enumerate(self.group.links)}


def _rates(body: Body, rate: States, bend: States) -> Body:
    return body.moving(rate[:, 0] + 1j * rate[:, 1], rate[:, 2], bend[:, 0] + 1j * bend[:, 1], bend[:, 2])

"""Groups of class III and higher, and gear trains: Newton on all loop equations of the group at once.

J x' = -g'(known), J x'' = -g''(known, x'), the right-hand sides being analytic. The path from the problem's own
position to all others is walked in small strides, so that the assembly found there is kept.
"""

from __future__ import annotations

from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from ..closed.off_centre import places
from ..run import Run, Track, wrapped
from ..state import Bodies, Body, Reals
from .assemblies import chosen, distances, is_guessed
from .driven import asked_of, drives_in
from .guess import first_guess
from .loops import ITERATIONS, Loops, States, with_rates
from .scatter import distinct, random_starts, scattered
from .standing import carriers
from .stride import Strode, points_there, reached, stride

EXACT = 1e-9  # of the mechanism's size: guesses nearer to an assembly than this are one


@dataclass(frozen=True, slots=True)
class Newton(Loops):
    """The step of one group."""

    sign: float = 1.0
    two: bool = False
    joint: str = field(default="", kw_only=True)
    # strides from the own position → the last of them, which led there
    walked: dict[int, Strode] = field(default_factory=dict, compare=False, repr=False, init=False)
    # every assembly at the own position, once sought
    met: list[States] = field(default_factory=list, compare=False, repr=False, init=False)

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """Walk the path from the own position outwards, then solve all positions asked for at once."""
        assert run.track is not None
        track, known = run.track, self.known(bodies, run.track, run.q)
        states = np.full((len(run.q), len(self.group.links), 3), np.nan)
        if 0 not in self.walked:
            self.begin(self._own(_one(known, track.own), _one(bodies, track.own)))
        states[track.own] = self.walked[0].end
        for way in (1, -1):
            self._walk(states, known, track, way)
        self._fill(states, known, run.q, track)
        return self.bodies_at(states)

    def begin(self, state: NDArray[np.float64]) -> None:
        """Take this assembly at the own position, where none was taken yet; angles within half a turn, from which those
        of all other positions go on, as nothing tells whole turns where nothing rolls."""
        own = np.array(state)
        if not any(r.rolls for r in self.rows):
            own[..., 2] = wrapped(own[..., 2])
        self.walked[0] = Strode((1.0,), (own,))

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """Velocities, then accelerations, from one Jacobian."""
        still = {**bodies, **{n: with_rates(bodies[n], np.zeros((1, 3)), np.zeros((1, 3))) for n in self.group.links}}
        jacobian = self.jacobian(still)
        blank = np.eye(jacobian.shape[1])
        lost: NDArray[np.bool_] = np.asarray(np.isnan(jacobian).any(axis=(1, 2)))
        jacobian = np.where(lost[:, None, None], blank, jacobian)
        lost |= np.isnan(run.alive(1 / np.linalg.cond(jacobian), 1.0, self.group.links))
        jacobian = np.where(lost[:, None, None], blank, jacobian)
        rates = self.linear(jacobian, self.stack([r.rate(still[r.a], still[r.b]) for r in self.rows], len(run.q)))
        rates[lost] = np.nan
        moved = {**bodies, **self.moving(bodies, rates, np.zeros_like(rates))}
        bends = self.linear(jacobian, self.stack([r.accel(moved[r.a], moved[r.b]) for r in self.rows], len(run.q)))
        return self.moving(bodies, rates, bends)

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """No gap to tell: the loops do not close at all."""
        return np.full(1, np.nan)

    def assemblies(self, here: Bodies) -> States:
        """Every assembly of a group with a drive inside, the known links (and the drive) being in their own positions;
        sought once."""
        if not self.met:
            seeds = random_starts(self.mech, len(self.group.links))
            self.met.append(distinct(self.solve(seeds, here, seeds, here, ITERATIONS), self.size))
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
            return np.asarray(self.solve(guess, here, None, here, ITERATIONS)[0])
        exact = is_guessed(self.mech, self.group) and self._exact(guess, here)
        seeds = (
            guess
            if exact
            else np.concatenate(
                [guess, scattered(guess, self.size, 0.15 if is_guessed(self.mech, self.group) else 0.5)]
            )
        )
        return chosen(self.mech, self.group, self.solve(seeds, here, seeds, here, ITERATIONS), known)

    def _exact(self, guess: States, here: Bodies) -> bool:
        """Whether the guesses are an assembly: then none lies nearer to them."""
        told = {*self.mech.guesses, *(p for name in here for p in self.mech.link(name).points)}
        whole = all(len(told & set(self.mech.link(name).points)) > 1 for name in self.group.links)
        return whole and bool(
            distances(self.mech, self.group, self.solve(guess, here, guess, here))[0] < EXACT * self.size
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
            if index - track.own not in self.walked:
                here = _one(known, index)
                if not all(np.isfinite(body.at + body.unit).all() for body in here.values()):
                    return
                seed = 2 * states[last] - states[before] if before != last else states[last]
                self.walked[index - track.own] = stride(self, states[last], seed, _one(known, last), here)
            states[index] = self.walked[index - track.own].end
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
            start, led = path[track.near][pick], seed[pick]
            found[pick] = self.solve(led, here, start, ago)
            for k in np.flatnonzero(~points_there(found[pick], start, led, self.size)):
                at = int(pick[k])
                strode = self.walked.get(int(ahead[at]) - track.own)
                if strode is not None:
                    past, then, now = _one(known, track.near[at]), _one(known, ahead[at]), _one(here, k)
                    found[at] = reached(self, strode, abs(float(reach[at])), (past, then), now)
        states[asked] = found


def _one(bodies: Bodies, at: int | np.intp) -> Bodies:
    """These links at one position."""
    return {name: body.take(np.array([at])) for name, body in bodies.items()}

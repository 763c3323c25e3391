"""One equilibrium while friction is raised: where it leads at a larger share, and whether what is found there is it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ....board.board import NO_LENGTH
from ....mechanism.groups.assur import ends
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....plane import Reals, nominal
from ..acting import Acting
from ..state import Statics
from .secant import Couples

FAR = 0.25  # of the largest reaction: what one changes by from one share of the friction to the next
CLOSE = 0.01  # the same, from one side of a kink to the other


@dataclass(frozen=True, slots=True, kw_only=True)
class Reached:
    """A share of the friction, and the couples with which it is in equilibrium.

    answering: det(1 − G) as it was last told, 1 with no friction; side: its sign along this equilibrium.
    """

    share: float
    couples: dict[tuple[str, str], Reals]
    answering: float = 1.0
    side: int = 1


def is_far(found: Statics, guide: Statics, far: float = FAR) -> bool:
    """Whether a reaction changed by much of what its links bear; little of the largest of all is never far, for what
    friction alone loads begins at nothing."""
    little = min(far, CLOSE) * _largest(found.acting.values())
    return any(
        abs(complex(nominal(force.vector - old.vector))) > max(little, far * min(_borne(found, link) for link in key))
        for key, force in found.acting.items()
        if (old := guide.push(*key)) is not None
    )


def _borne(st: Statics, link: str) -> float:
    """The largest reaction on this link, beside which another is small; of a two-force link, whose reactions vanish
    together where they change sides, and of the frame the largest of all."""
    on = [force for key, force in st.acting.items() if link in key]
    loaded = bool(st.loads.on(link) or st.inertia.get(link))
    counted = on if link != FRAME and (loaded or len(on) > 2) else st.acting.values()
    return _largest(counted)


def _largest(forces: Iterable[Acting]) -> float:
    return max((abs(complex(nominal(force.vector))) for force in forces), default=0.0)


def determinant(answer: np.ndarray) -> float:
    """det(1 − G): 1 with no friction, where the couples that come out do not answer those put in. Along one equilibrium
    it never passes 0, but ∞ it may, where with these couples held fast a link could not be balanced; and where a
    reaction changes sides it may leap past either. An equilibrium that is led back there has no neighbour beyond, so
    one that is found close by beyond is the same, grown."""
    return float(np.linalg.det(np.eye(len(answer)) - answer))


def is_past_pole(before: float, after: float) -> bool:
    """Whether det(1 − G) changed its sign from one share to the next through ∞, not through 0."""
    return min(abs(before), abs(after)) > 1.0


def bearing_nothing(st: Statics) -> frozenset[str | tuple[str, str]]:
    """The pins and slides without any force."""
    bare: set[str | tuple[str, str]] = set()
    for joint in st.mech.joints:
        force = st.push(*ends(joint))
        if force is None or abs(complex(nominal(force.vector))) >= NO_LENGTH:
            continue
        if isinstance(joint, Revolute):
            bare.add(joint.point)
        elif isinstance(joint, Prismatic):
            bare.add((joint.block, joint.guide))
    return frozenset(bare)


def foreseen(path: Sequence[Reached], share: float) -> Couples:
    """The couples at a further share, from those of the last two: as 1/(c − share), for so they run off, and die away
    without ever changing sides; to first order in line."""
    last = path[-1]
    if len(path) < 2 or path[-2].couples.keys() != last.couples.keys():
        return last.couples
    before = path[-2]
    onward = (share - last.share) / (last.share - before.share)
    return {key: _produced(c, (c - before.couples[key]) * onward) for key, c in last.couples.items()}


def _produced(size: Reals, rise: Reals) -> Reals:
    """size² / (size − rise); in line where that would run off."""
    bent = rise * np.sign(size) < 0.5 * np.abs(size)
    found: Reals = np.where(bent, np.square(size) / np.where(bent, size - rise, 1.0), size + rise)[()]
    return found

"""Degrees of freedom: F = 3n - 2 p_L - p_H."""

from __future__ import annotations

from ...errors import MobilityError
from ...foundation.slotted import dataclass
from ...words import Words
from ..model import Joint, Mechanism, Prismatic, Revolute, Rolling
from .assur import ends, hinges, is_held
from .repeats import repeated
from .sliding import slides_alone


@dataclass(frozen=True, slots=True, kw_only=True)
class Mobility:
    """Counts of moving links n, lower pairs p_L (a hinge of k links counts k - 1), higher pairs p_H, and drives.

    Rolling with contact and no slip fixes two coordinates and counts as a lower pair; where links hold the
    gear's centre at its distance already it counts as a higher pair. A pin in a slot counts as hinge and slide.
    A contact is one higher pair; the link by which kinematics replaces it, and that link's joints, do not count.
    """

    links: int
    lower: int
    higher: int
    drives: int

    @property
    def freedom(self) -> int:
        """F = 3n - 2 p_L - p_H."""
        return 3 * self.links - 2 * self.lower - self.higher

    def __str__(self) -> str:
        n, low, high = self.links, self.lower, self.higher
        return f"F = 3n - 2p_L - p_H = 3·{n} - 2·{low} - {high} = {self.freedom}"


_STUCK = Words(
    "：机构不能运动；请去掉多余的运动副，或补上缺少的构件",
    ": nothing can move; remove a redundant joint, or add the missing link",
)


def mobility(mech: Mechanism) -> Mobility:
    """The counts and F of a mechanism."""
    pins = sum(len(names) - 1 for names in _pins(mech) if names)
    slides = sum(isinstance(joint, Prismatic) for joint in _real(mech))
    rolls = [is_held(mech, joint) for joint in mech.joints if isinstance(joint, Rolling)]
    return Mobility(
        links=len(mech.bodies),
        lower=pins + slides + rolls.count(False),
        higher=rolls.count(True) + len(mech.contacts),
        drives=len(mech.drives),
    )


def _pins(mech: Mechanism) -> list[tuple[str, ...]]:
    """The links at each hinge, without substitutes."""
    return [tuple(name for name in names if name not in mech.substitutes) for names in hinges(mech).values()]


def _real(mech: Mechanism) -> list[Joint]:
    """The joints, without those of substitutes."""
    return [joint for joint in mech.joints if not mech.substitutes & set(ends(joint))]


def check(mech: Mechanism) -> Mobility:
    """The counts, once F equals the number of drives; MobilityError with the remedy where it does not."""
    count = mobility(mech)
    if count.freedom == count.drives:
        return count
    said = Words(
        f"{count}，而给了 {count.drives} 个原动件",
        f"{count}, but {count.drives} drive{'s are' if count.drives != 1 else ' is'} given",
    )
    if count.freedom < 1:
        slides = (joint for joint in _real(mech) if isinstance(joint, Prismatic))
        raise MobilityError(said + (slides_alone(slides) or repeated(mech) or _STUCK))
    if count.freedom > count.drives:
        loose = [name for name in mech.numbered if _joints_at(mech, name) < 2]
        hint = f" (links with a single joint: {', '.join(loose)})" if loose else ""
        raise MobilityError(
            said
            + Words(
                f"；请再给 {count.freedom - count.drives} 个原动件，或补上缺少的运动副"
                + (f"（只有一个运动副的构件：{', '.join(loose)}）" if loose else ""),
                f": drive {count.freedom - count.drives} more link(s), or add the missing joint{hint}",
            )
        )
    raise MobilityError(
        said
        + Words(
            f"；只保留其中 {count.freedom} 个，或去掉一个运动副",
            f": keep only {count.freedom} of them, or remove a joint",
        )
    )


def _joints_at(mech: Mechanism, name: str) -> int:
    """How many joints the link has (a hinge counts once), contacts included."""
    pins = sum(name in names for names in _pins(mech) if len(names) > 1)
    others = sum(name in ends(joint) for joint in _real(mech) if not isinstance(joint, Revolute))
    return pins + others + sum(name in contact.links for contact in mech.contacts)

"""Where the pressure angle of a mechanism is told: which link is driven, by what, and at which of its points.

``alpha_C``, ``gamma_C`` the pressure and the transmission angle (deg, to 90) at the point C of a driven link on the
frame; ``alpha``, ``gamma`` alone where the mechanism has only one such link.
"""

from __future__ import annotations

from ...errors import MobilityError
from ...foundation.slotted import dataclass, replace
from ...names import Named, Sort
from ..groups.assur import Dyad, decompose, ends
from ..model import FRAME, Joint, Mechanism, Prismatic, Revolute, Rolling


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """A link on the frame, and the link of two forces by which it is driven.

    at: the point at which the force acts. press: the other pin of a rod whose line is that of the force, or the
    sliding pair across which it is. seat: the joint of the driven link with the frame.
    joints: those of the driving link, the one between both last.
    """

    by: str
    link: str
    at: str
    press: str | Prismatic
    seat: Revolute | Prismatic
    joints: tuple[Joint, Joint]
    name: str = ""  # the point as the keys tell it: nothing where there is one driven link only

    @property
    def kind(self) -> str:
        """By what it is driven: rod, guide."""
        return "rod" if isinstance(self.press, str) else "guide"

    @property
    def thought(self) -> bool:
        """Whether the point is one of the driving link, under which that of the driven link slides away."""
        return isinstance(self.joints[1], Prismatic)

    @property
    def symbol(self) -> str:
        """The subscript as it is printed."""
        return f"_{{{self.name}}}" if self.name else ""

    @property
    def alpha(self) -> Named:
        """The pressure angle."""
        return Named(f"alpha_{self.name}".rstrip("_"), f"α{self.symbol}", "deg", sort=Sort.PRESSURE)

    @property
    def gamma(self) -> Named:
        """The transmission angle."""
        return Named(f"gamma_{self.name}".rstrip("_"), f"γ{self.symbol}", "deg", sort=Sort.PRESSURE)


def driven_links(mech: Mechanism) -> tuple[Driven, ...]:
    """Every link on the frame that a link of two forces drives, in the order in which they are found.

    Not those that teeth or cams drive, nor those whose driving link carries a further group.
    """
    try:
        groups = () if mech.drive.between else decompose(mech)
    except MobilityError:
        return ()
    busy = {outer.parent for group in groups for outer in group.outer} | _meshed(mech)
    found = [
        driven
        for group in groups
        if group.dyad is not None and not mech.substitutes & set(group.links)
        for driven in _of_dyad(group.dyad)
        if driven.by not in busy
    ]
    return tuple(_named(driven, found) for driven in found)


def _meshed(mech: Mechanism) -> set[str]:
    """Links on which teeth or a cam press: no links of two forces."""
    rolled = {link for joint in mech.joints if isinstance(joint, Rolling) for link in ends(joint)}
    return rolled.union(*(contact.links for contact in mech.contacts))


def pressure_quantities(mech: Mechanism) -> dict[str, Named]:
    """Every pressure and transmission angle by its key."""
    return {named.key: named for driven in driven_links(mech) for named in (driven.alpha, driven.gamma)}


def _named(driven: Driven, found: list[Driven]) -> Driven:
    """With the name that its keys have: C, or C3 where the force of another link acts on C too."""
    if len(found) == 1:
        return driven
    alike = [other for other in found if other.at == driven.at]
    return replace(driven, name=driven.at + (driven.link if len(alike) > 1 else ""))


def _of_dyad(d: Dyad) -> tuple[Driven, ...]:
    """The link of a dyad that hangs on the frame, driven by the other; none where none does, or both do."""
    if d.parent_k == FRAME != d.parent_j:
        led = _led(d.link_j, d.link_k, d.outer_j, d.inner, d.outer_k)
    elif d.parent_j == FRAME != d.parent_k:
        led = _led(d.link_k, d.link_j, d.outer_k, d.inner, d.outer_j)
    else:
        return ()
    return () if led is None else (led,)


def _led(by: str, link: str, outer: Joint, inner: Joint, seat: Joint) -> Driven | None:
    """How one link of a dyad drives the other; nothing where it passes on a couple alone, or where teeth mesh."""
    if not isinstance(seat, Revolute | Prismatic):
        return None
    match outer, inner:
        case Revolute(), Revolute():
            return _driven(by, link, inner.point, outer.point, seat, (outer, inner))
        case Prismatic(), Revolute():
            return _driven(by, link, inner.point, outer, seat, (outer, inner))
        case Revolute(), Prismatic():
            return _driven(by, link, outer.point, inner, seat, (outer, inner))
    return None


def _driven(
    by: str, link: str, at: str, press: str | Prismatic, seat: Revolute | Prismatic, joints: tuple[Joint, Joint]
) -> Driven:
    return Driven(by=by, link=link, at=at, press=press, seat=seat, joints=joints)

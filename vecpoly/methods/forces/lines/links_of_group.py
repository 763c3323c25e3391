"""A class II group seen by its forces: the unloaded link, which only passes a force on, and the loaded one."""

from __future__ import annotations

from dataclasses import dataclass

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Contact, Joint
from ..state import Statics


@dataclass(frozen=True, slots=True, kw_only=True)
class TwoForce:
    """The unloaded link `link` between the loaded link `on` (joint `inner`) and its parent `by` (joint `outer`).

    contact: the higher pair for which the link is only the substitute;
    then the parent presses on the loaded link directly.
    """

    link: str
    on: str
    by: str
    inner: Joint
    outer: Joint
    contact: Contact | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Held:
    """The loaded link and the joint by which it hangs on its parent."""

    link: str
    parent: str
    joint: Joint


def pieces(st: Statics, d: Dyad) -> tuple[TwoForce, Held] | None:
    """The group as a two-force link and a held link; None where both links are loaded.

    Where neither is loaded, the first counts as the two-force link.
    """
    contact = next((c for c in st.mech.contacts if c.substitute in (d.link_j, d.link_k)), None)
    first_free = contact.substitute == d.link_j if contact else not st.loaded(d.link_j)
    if not first_free and not contact and st.loaded(d.link_k):
        return None
    j, k = (d.link_j, d.parent_j, d.outer_j), (d.link_k, d.parent_k, d.outer_k)
    (free, by, outer), (held, parent, joint) = (j, k) if first_free else (k, j)
    return (
        TwoForce(link=free, on=held, by=by, inner=d.inner, outer=outer, contact=contact),
        Held(link=held, parent=parent, joint=joint),
    )

"""What a mechanism is taken apart into: Assur groups, and how they hang on what is known."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from ...words import Words
from ..model import Joint
from ..rams import Ram


@dataclass(frozen=True, slots=True, kw_only=True)
class Outer:
    """A joint by which `link` of the group hangs on the known link `parent`."""

    joint: Joint
    link: str
    parent: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Dyad:
    """A class II group: link j on its parent, link k on its parent, and the inner joint between j and k.

    Order: of the outer joints R stands before P, and P before G (a rolling joint): RRP has its outer hinge
    first, RPP its outer hinge, then the inner P, then the outer P. Else j stands before k in the mechanism.
    """

    kind: str
    link_j: str
    link_k: str
    outer_j: Joint
    parent_j: str
    inner: Joint
    outer_k: Joint
    parent_k: str

    @property
    def links(self) -> tuple[str, str]:
        """j and k."""
        return self.link_j, self.link_k


_CLASS = {"I": "Ⅰ", "II": "Ⅱ", "III": "Ⅲ", "IV": "Ⅳ", "V": "Ⅴ", "VI": "Ⅵ"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Group:
    """Links solved together.

    kind: RRR RRP RPR PRP RPP (with G where a gear rolls), "gear" and "rack" (one link), "gear train", "class III", ...;
    with a drive inside "cylinder RR" or "cylinder RP" (a cylinder, a hinge,
    and the other link on its outer hinge or guide), else "driven".
    """

    kind: str
    links: tuple[str, ...]
    inner: tuple[Joint, ...]
    outer: tuple[Outer, ...]
    dyad: Dyad | None = None
    ram: Ram | None = None

    @property
    def subject(self) -> Dyad | Ram | Group:
        """What a textbook method is told: the dyad, the cylinder with its link, or the group itself."""
        return self.dyad or self.ram or self

    @property
    def label(self) -> str:
        """Its links in one word: 23; a pin in a slot by its letter: 2B."""
        return "".join(name.removeprefix("pin") for name in self.links)

    @property
    def told(self) -> Words:
        """The links in a sentence: 2 and 3; the block that is thought about a pin in a slot is told as that pin."""
        return Words(
            "、".join(name.replace("pin", "销 ") for name in self.links),
            " and ".join(name.replace("pin", "pin ") for name in self.links),
        )

    @property
    def name(self) -> Words:
        """For messages: RRR group 2, 3."""
        number = self.kind.removeprefix("class ")
        own = {"driven": "含驱动的杆组", "gear train": "轮系"}
        zh = own.get(self.kind, f"{self.kind} 组") if number == self.kind else f"{_CLASS.get(number, number)} 级杆组"
        return Words(f"{zh}（构件 {self.told.zh}）", f"{self.kind} group {self.told.en.replace(' and ', ', ')}")

"""The structure of a mechanism: its joints in one position, and the driving links to be considered.

joints:
  A: R(0, 1) at (0, 0)
  B: R(1, 2) at (35, 92)
  C: R(2, 3) at (110, 120)
  D: P(3, 0) at (110, 0) along (0, 1)
drivers: [1]          # several possibilities: [1, 5]; two links that drive together: 1+3
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Annotated, ClassVar

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator

from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Device
from .pairs_read import Letter, read_pair
from .structure_named import DETERMINED, F_LOCAL, F_LOW, N_LOW, P_H, P_L, P_LOW, P_REDUNDANT, F, N, class_, groups
from .structure_pairs import FRAME, Chain, Pair, Written, natural
from .structure_told import FIGURE, structure_task, told_drivers

Joint = Annotated[Written, BeforeValidator(read_pair), WithJsonSchema({"type": "string"})]
OFF_LINE = 0.01  # share of the distance between the centres by which a contact may stand beside their line


class Structure(Device):
    """A kinematic chain; sought are its counts, its degree of freedom, its Assur groups and its class."""

    kind: ClassVar[str] = "structure"
    joints: Annotated[dict[Letter, Joint], Field(min_length=1)]
    drivers: tuple[str, ...] = ()
    frame: str = FRAME  # the frame's number as printed
    links: tuple[str, ...] = ()  # all of them, if they are to be checked against the joints

    @model_validator(mode="after")
    def _is_a_mechanism(self) -> Structure:
        names = {_plain(link, self.frame) for joint in self.joints.values() for link in joint.links}
        if FRAME not in names:
            raise FaultError(
                Words(
                    "没有运动副与机架相连；机架为构件 0；如写 A: R(0, 1) at (0, 0)",
                    "no joint joins a link to the frame; the frame is link 0: write e.g. A: R(0, 1) at (0, 0)",
                ),
                code="spelling",
                keys=("joints",),
            )
        if self.links and (odd := names ^ {*(_plain(link, self.frame) for link in self.links), FRAME}):
            raise FaultError(
                Words(
                    f"构件 {', '.join(sorted(odd, key=natural))} 只出现在 links 或 joints 之一中；两处应一致",
                    f"link {', '.join(sorted(odd, key=natural))} stands in links or in joints, but not in both",
                ),
                keys=("links", "joints"),
            )
        chain = self.chain
        if loose := _loose(chain):
            told = f"links {', '.join(loose)} hang" if len(loose) > 1 else f"link {loose[0]} hangs"
            raise FaultError(
                Words(
                    f"构件 {', '.join(loose)} 没有经运动副与机架相连；请补上缺少的运动副",
                    f"{told} on nothing: no chain of joints leads to the frame; add the missing joint",
                ),
                keys=("joints",),
            )
        for pair in chain.pairs:
            _check_contact(pair)
        self._check_drivers(chain)
        return self

    def _check_drivers(self, chain: Chain) -> None:
        for together in self.drive_sets:
            if len(set(together)) < len(together):
                raise FaultError(
                    Words(
                        f"原动件 {'+'.join(together)}：有构件重复；每个原动件只写一次",
                        f"drivers {'+'.join(together)}: a link stands twice; name each link that drives together once",
                    ),
                    code="contradiction",
                    keys=("drivers",),
                )
            for link in together:
                _check_driver(chain, link)

    @property
    def chain(self) -> Chain:
        """The links and pairs as given."""
        pairs = tuple(self._pair(letter, joint) for letter, joint in self.joints.items())
        links = {link for pair in pairs for link in pair.links} - {FRAME}
        return Chain(tuple(sorted(links, key=natural)), pairs)

    def _pair(self, letter: str, joint: Written) -> Pair:
        links = tuple(_plain(link, self.frame) for link in joint.links)
        return Pair(
            letter=letter,
            form=joint.form,
            links=links,
            at=joint.at,
            along=joint.along,
            about=tuple(self._centre(letter, centre) for centre in joint.about),
        )

    def _centre(self, letter: str, centre: complex | str | None) -> complex | None:
        if not isinstance(centre, str):
            return centre
        if centre not in self.joints or centre == letter:
            raise FaultError(
                Words(
                    f"运动副 {letter}：没有可作曲率中心的运动副 {centre}；已有：{', '.join(self.joints)}",
                    f"joint {letter}: there is no other joint {centre} to be the centre; known: "
                    f"{', '.join(self.joints)}",
                ),
                code="unknown-name",
                keys=(("joints", letter),),
            )
        return self.joints[centre].at

    @property
    def drive_sets(self) -> tuple[tuple[str, ...], ...]:
        """The driving links, one set for each possibility."""
        return tuple(tuple(part.strip() for part in text.split("+")) for text in self.drivers)

    def number(self, link: str) -> str:
        """A link's number as printed."""
        return (self.frame if link == FRAME else link).replace("'", "′")

    def free_number(self, index: int) -> str:
        """The number of the index-th link that replaces a higher pair: the next one that no link and no frame has."""
        used = [natural(link)[0] for link in (*self.chain.links, self.frame)]
        return str(max((number for number in used if number < 10**6), default=0) + 1 + index)

    @property
    def touching(self) -> bool:
        """Whether it has higher pairs."""
        return any(not joint.form.is_lower for joint in self.joints.values())

    def task(self, asked: Collection[str]) -> Words:
        """What figure it is of."""
        frame = "" if self.frame == FRAME else self.number(FRAME)
        return structure_task(frame, touching=self.touching, driven=bool(self.drivers))

    def quantities(self) -> tuple[Named, ...]:
        """The counts, F, whether the motion is determined;
        after replacement of the higher pairs; class and groups for each driver."""
        low = (N_LOW, P_LOW, F_LOW) if self.touching else ()
        classes = tuple(named for together in self.drive_sets for named in (groups(together), class_(together)))
        return (N, P_L, P_H, F_LOCAL, P_REDUNDANT, F, *((DETERMINED,) if self.drivers else ()), *low, *classes)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Nothing has a value: places are drawn."""
        return ()

    def told(self) -> tuple[Words, ...]:
        """The figure, which has the links and joints; the drivers, one possibility after the other."""
        sets = [[self.number(_plain(link, self.frame)) for link in together] for together in self.drive_sets]
        return (FIGURE, *([told_drivers(sets)] if sets else []))

    @property
    def size(self) -> float:
        """The larger side of the sketch (m)."""
        places = [joint.at for joint in self.joints.values()]
        return (
            max(
                max(p.real for p in places) - min(p.real for p in places),
                max(p.imag for p in places) - min(p.imag for p in places),
            )
            or 0.1
        )


def _plain(link: str, frame: str) -> str:
    """A link's name inside: the frame is always 0."""
    return FRAME if link in (FRAME, frame) else link


def _loose(chain: Chain) -> tuple[str, ...]:
    """Links from which no chain of joints leads to the frame."""
    reached = {FRAME}
    while new := {link for pair in chain.pairs if reached & set(pair.links) for link in pair.links} - reached:
        reached |= new
    return tuple(link for link in chain.links if link not in reached)


def _check_contact(pair: Pair) -> None:
    """The contact lies on the line of the centres."""
    if pair.form.is_lower:
        return
    one, two = pair.about
    if one is None or two is None:
        if one == pair.at or two == pair.at:
            raise FaultError(
                Words(
                    f"运动副 {pair.letter}：尖点与平面接触时无公法线；请给轮廓一个小的圆角半径",
                    f"joint {pair.letter}: a point on a flat face has no normal; let the profile have a small radius",
                ),
                keys=(("joints", pair.letter),),
            )
        return
    if abs(two - one) < 1e-9:
        raise FaultError(
            Words(
                f"运动副 {pair.letter}：两轮廓的曲率中心重合，处处接触，不是高副",
                f"joint {pair.letter}: both profiles have the same centre; they touch everywhere, and that is "
                "no higher pair",
            ),
            code="spelling",
            keys=(("joints", pair.letter),),
        )
    off = abs(((two - one).conjugate() * (pair.at - one)).imag) / abs(two - one)
    if off > OFF_LINE * abs(two - one):
        raise FaultError(
            Words(
                f"运动副 {pair.letter}：接触点偏离两曲率中心的连线（公法线）{1e3 * off:.2f} mm；请将其置于连线上",
                f"joint {pair.letter}: the contact stands {1e3 * off:.2f} mm beside the line of the two "
                "centres, which is the common normal; put it on the line",
            ),
            keys=(("joints", pair.letter),),
        )


def _check_driver(chain: Chain, link: str) -> None:
    """A driver is a link, joined to the frame by a lower pair."""
    if link not in chain.links:
        raise FaultError(
            Words(
                f"原动件 {link} 不是已有的构件；构件有：{', '.join(chain.links)}",
                f"driver {link} is no link; links: {', '.join(chain.links)}",
            ),
            code="spelling",
            keys=("drivers",),
        )
    if not any(pair.form.is_lower and FRAME in pair.links for pair in chain.at(link)):
        raise FaultError(
            Words(
                f"原动件 {link} 既不铰接于机架，也不在机架上移动；请另取与机架相连的构件",
                f"driver {link} is neither pinned to the frame nor slides on it; name a link that is",
            ),
            code="missing",
            keys=("drivers",),
        )

"""Angular velocities from centres: at P_ij both links have one velocity,
ω_i · P_ik P_ij = ω_j · P_jk P_ij, k being the frame."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ....algebra.formula import sym
from ....algebra.quantity import Expr, Quantity, magnitude
from ....algebra.worked import worked
from ....board.construction import Reading
from ....errors import NoMethodError
from ....mechanism.asked.centres import real_links
from ....mechanism.model import FRAME, Prismatic
from ....names import omega
from ....plane import Points, Reals, cross, dot, nominal, unit
from ....words import Words
from ..state import CentreFigure
from .proportion import proportioned
from .senses import sense_told, ways
from .spots import Spot, apart, given, measured, spot_of

CLOSE = 1e-4  # mm: a centre so near an absolute one gives no ratio


@dataclass(slots=True)
class Motions:
    """What is known of the links' motion: ω of those that turn (rad/s),
    the velocity of those that translate (m/s), lettered places."""

    fig: CentreFigure
    turns: dict[str, Reals] = field(default_factory=dict)
    glides: dict[str, Points] = field(default_factory=dict)
    sizes: dict[str, Quantity] = field(default_factory=dict)  # |ω_2|, |v_3| under their links, as in formulas
    places: dict[str, Points] = field(default_factory=dict)  # of points found on the figure: E2

    def __post_init__(self) -> None:
        drive = self.fig.mech.drive
        rate = magnitude(
            f"{'v' if drive.slide else 'ω'}_{drive.link}", abs(drive.rate), "m/s" if drive.slide else "rad/s"
        )
        self.sizes[drive.link] = rate
        if drive.slide:
            joint = next(
                j
                for j in self.fig.mech.joints
                if isinstance(j, Prismatic) and j.block == drive.link and j.guide == FRAME
            )
            self.turns[drive.link] = 0.0
            self.glides[drive.link] = self.fig.desk.guide_line(joint).along * drive.rate
        else:
            self.turns[drive.link] = drive.rate

    def find(self, link: str) -> None:
        """Make the motion of a link known, from the driver where its centres allow it, else over another link."""
        if link not in self.turns:
            self._find(link, frozenset())

    def _find(self, link: str, asking: frozenset[str]) -> None:
        driver = self.fig.mech.drive.link
        others = [
            k for k in real_links(self.fig.mech) if k not in (link, FRAME) and k not in asking and self._usable(k, link)
        ]
        for via in sorted(others, key=lambda k: (self._far(k, link), k != driver, k not in self.turns)):
            if via not in self.turns:
                try:
                    self._find(via, asking | {link})
                except NoMethodError:
                    continue
            if self._carries(via, link):
                self._from(via, link)
                return
        raise NoMethodError(
            Words(
                f"在此位置由构件 {link} 的瞬心求不出其速度；请去掉 method: centres",
                f"the centres of link {link} lie so that its velocity does not follow from them here; leave out "
                "'method: centres'",
            )
        )

    def _far(self, via: str, link: str) -> int:
        return sum(self.fig.far(*pair) for pair in ((via, link), (link, FRAME), (via, FRAME)))

    def _usable(self, via: str, link: str) -> bool:
        own, common = self.fig.known.of(link, FRAME), self.fig.known.of(via, link)
        if own.endless or common.endless:
            return own.endless is not common.endless
        return abs(own.spot() - common.spot()) > CLOSE

    def _carries(self, via: str, link: str) -> bool:
        """Whether the motion of `via` tells that of the link: a common centre at infinity does only where both turn."""
        return not self.fig.known.of(via, link).endless or via not in self.glides

    def _from(self, via: str, link: str) -> None:
        own, common = self.fig.known.of(link, FRAME), self.fig.known.of(via, link)
        if own.endless and via in self.glides:
            self._gliding_alike(via, link)
        elif own.endless:
            self._translating(via, link)
        elif common.endless:
            self._alike(via, link)
        else:
            self._turning(via, link)

    def _alike(self, via: str, link: str) -> None:
        """P_ij at infinity: the links turn alike."""
        p = self.fig.letters(via, link)
        self.fig.board.step(
            Words(
                f"${p}$ 在无穷远处，构件 {link} 与 {via} 的角速度相等：$ω_{link}$ = $ω_{via}$。",
                f"The centre ${p}$ is at infinity: links {link} and {via} have the same angular velocity, $ω_{link}$ "
                f"= $ω_{via}$.",
            ),
            self.fig.pane,
        )
        self._keep(link, self.turns[via], self.sizes[via])

    def _turning(self, via: str, link: str) -> None:
        """ω_j = v_Pij / P_jk P_ij."""
        common, own = spot_of(self.fig, via, link), spot_of(self.fig, link, FRAME)
        if via in self.glides:
            self._driven_by_glide(via, link, own, common)
        else:
            self._driven_by_turn(via, link, own, common)

    def _driven_by_glide(self, via: str, link: str, own: Spot, common: Spot) -> None:
        """ω_j = v_i / P_jk P_ij: all points of the other link have one velocity."""
        self.fig.board.step(
            Words(
                f"构件 {via} 平动，${common.letter}$ 处两构件速度相同，$v_{via}$ = $ω_{link}{_length(own, common)}$：",
                f"Link {via} translates; at ${common.letter}$ both have one velocity, "
                f"$v_{via}$ = $ω_{link}{_length(own, common)}$:",
            ),
            self.fig.pane,
        )
        expr: Expr = self.sizes[via] / self.metres(own, common)
        way = np.sign(nominal(cross(common.at - own.at, self.glides[via])))
        self._keep(link, way * expr.value, expr)

    def _driven_by_turn(self, via: str, link: str, own: Spot, common: Spot) -> None:
        """ω_j = ω_i · P_ik P_ij / P_jk P_ij; the links turn alike where P_ij lies outside."""
        fig = self.fig
        base = spot_of(fig, via, FRAME)
        outside = bool(nominal(dot(common.at - base.at, common.at - own.at)) > 0)
        sense = sense_told(own.letter, common.letter, base.letter, outside)
        fig.board.step(
            Words(
                f"构件 {via}、{link} 在 ${common.letter}$ 处速度相同，$ω_{via}{_length(base, common)}$ = "
                f"$ω_{link}{_length(own, common)}$；{sense.zh}：",
                f"At ${common.letter}$ links {via} and {link} have one velocity, "
                f"$ω_{via}{_length(base, common)}$ = $ω_{link}{_length(own, common)}$; "
                f"{sense.en}:",
            ),
            fig.pane,
        )
        arms = self._part(base, common, own), self._part(own, common, base)
        expr = self.sizes[via] * arms[0] / arms[1]
        way = np.sign(nominal(self.turns[via])) * (1.0 if outside else -1.0)
        value = proportioned(fig.board, omega(link).key, way * expr.value, arms[0] / arms[1], "rad/s")
        self._keep(link, value, expr)

    def _translating(self, via: str, link: str) -> None:
        """v_j = v_Pij: all points of a translating link have the velocity of P_ij."""
        fig, common, base = self.fig, spot_of(self.fig, via, link), spot_of(self.fig, via, FRAME)
        told = ways(base.letter, common.letter, via) if apart(base, common) > CLOSE else Words("", "")
        fig.board.step(
            Words(
                f"构件 {link} 作平动，其各点速度等于 ${common.letter}$ 处的速度{told.zh}：",
                f"Link {link} translates: all its points have the velocity of ${common.letter}${told.en}:",
            ),
            fig.pane,
        )
        expr = self.sizes[via] * self.metres(base, common)
        size = fig.board.compute(f"v_{link}", expr, "m/s")
        self.turns[link], self.sizes[link] = 0.0, size
        way = 1j * unit(common.at - base.at) * np.sign(nominal(self.turns[via])) if apart(base, common) > CLOSE else 0j
        self.glides[link] = way * size.value
        self._read(link, 0.0, None)

    def _gliding_alike(self, via: str, link: str) -> None:
        """v_j = v_i: both links translate, and at P_ij they have one velocity."""
        p = self.fig.letters(via, link)
        self.fig.board.step(
            Words(
                f"构件 {link}、{via} 均作平动，在 ${p}$ 处速度相同：$v_{link}$ = $v_{via}$。",
                f"Links {link} and {via} both translate and have one velocity at ${p}$: $v_{link}$ = $v_{via}$.",
            ),
            self.fig.pane,
        )
        self.turns[link], self.sizes[link], self.glides[link] = 0.0, self.sizes[via], self.glides[via]
        self._read(link, 0.0, None)

    # -- lengths ------------------------------------------------------------------------------------------------

    def metres(self, p: Spot, q: Spot) -> Expr:
        """The length between two places in m: given, or μ_l times what is measured."""
        known = given(self.fig, p, q)
        return known if known is not None else self.fig.board.mu(self.fig.pane) * measured(self.fig, p, q)

    def _part(self, p: Spot, q: Spot, beside: Spot) -> Expr:
        """The same in a quotient of two lengths: plain mm where both are measured."""
        if given(self.fig, p, q) is None and given(self.fig, beside, q) is None:
            return measured(self.fig, p, q)
        return self.metres(p, q)

    # -- keeping ------------------------------------------------------------------------------------------------

    def _keep(self, link: str, value: Reals, expr: Expr) -> None:
        self.turns[link] = value
        self.sizes[link] = magnitude(f"ω_{link}", np.abs(value), "rad/s")
        if not isinstance(expr, Quantity):
            self.fig.board.write_worked(sym(f"ω_{link}"), expr, "rad/s")
        self._read(link, value, expr)

    def _read(self, link: str, value: Reals, expr: Expr | None) -> None:
        rel = omega(link)
        name, size = f"ω_{{{link}}}", float(nominal(value))
        remark = Words("该构件作平动", "the link only translates") if expr is None else None
        formula = worked(sym(name), expr if expr is not None else magnitude(name, 0.0, "rad/s"), "rad/s")
        self.fig.board.keep(
            Reading(key=rel.key, symbol=name, unit="rad/s", scalar=size, formula=formula, remark=remark), value
        )


def _length(p: Spot, q: Spot) -> str:
    return f"\u2009{p.letter}{q.letter}"

"""Demands on what was designed, `feed.alpha_max <= 40 deg`: what is asked, what was reached, whether it holds."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from ..errors import FaultError
from ..units.reckoning import Amount, names_in, reckon
from ..words import Words

_FORM = re.compile(r"(?P<left>.+?)\s*(?P<sign><=|>=|≤|≥|=)\s*(?P<right>.+?)(?:\s+within\s+(?P<within>\d+\.?\d*)\s*%)?")
_SIGNS = {"<=": "≤", ">=": "≥"}
WITHIN = 0.01  # of the value that is asked for, where nothing is said
_ROUNDING = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True)
class Demand:
    """A demand, judged: `asked` is the right side, `drawn` and `exact` what the left side is on paper and exactly.

    name: of the quantity on the left, where it is a single one. holds: judged by the exact value.
    """

    say: Words
    name: str
    sign: str
    asked: Amount
    drawn: Amount
    exact: Amount
    within: float

    @property
    def holds(self) -> bool:
        slack = _ROUNDING * max(abs(self.asked.si), abs(self.exact.si))
        if self.sign == "≤":
            return self.exact.si <= self.asked.si + slack
        if self.sign == "≥":
            return self.exact.si >= self.asked.si - slack
        return abs(abs(self.exact.si) - abs(self.asked.si)) <= self.within * abs(self.asked.si) + slack


def judged(say: Words, that: str, drawn: Mapping[str, Amount], exact: Mapping[str, Amount]) -> Demand:
    """The demand with its values; raises FaultError where it cannot be read, or its sides are of different kinds."""
    m = _FORM.fullmatch(that.strip())
    if m is None:
        raise FaultError(
            Words(
                f"“{that}”不是要求；如写 cam.alpha_max <= 40 deg 或 motion.K = 1.4 within 2 %",
                f"'{that}' is no demand; write e.g. cam.alpha_max <= 40 deg, or motion.K = 1.4 within 2 %",
            ),
            code="spelling",
        )
    reached, read, asked = reckon(m["left"], exact), reckon(m["left"], drawn), reckon(m["right"], exact)
    if reached.powers != asked.powers:
        raise FaultError(
            Words(
                f"“{that}”：左边是 {reached.shown()}，右边是 {asked.shown()}，量纲不同",
                f"'{that}': the left side is {reached.shown()} and the right one {asked.shown()}, of different kinds",
            ),
            code="wrong-unit",
        )
    names = names_in(m["left"])
    return Demand(
        say=say, name=names[0] if names == [m["left"].strip()] else "", sign=_SIGNS.get(m["sign"], m["sign"]),
        asked=asked, drawn=read, exact=reached, within=float(m["within"]) / 100 if m["within"] else WITHIN,
    )  # fmt: skip

"""One stage of a chain of stages, as it is written."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from ...errors import FaultError
from ...words import Words
from ..base import Advance, Which
from .written import Place


class Step(BaseModel):
    """One stage: a pin found on a ray, a pin joined by two links, or the other limit of a rocker.

    find, on, from: the pin `find` of the ray `on` that a bar joins to the known pin `from`; line: two letters, where it
    lies on the line between them instead of on the ray. join, to, side: the pin of two links of known length to the
    pins `to`, left or right of the ray between them. limits, about, crank, K, first: the rocker's pin, which lies in
    its `first` limit, the pivot of the crank, and the letter of its pin.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True, populate_by_name=True)
    find: str | None = None
    on: str | None = None
    start: str | None = Field(default=None, alias="from")
    line: str | None = None
    onto: Which = 1
    join: str | None = None
    to: str | None = None
    side: Literal["left", "right"] | None = None
    limits: str | None = None
    crank: str | None = None
    K: Advance | None = None
    first: Place | None = None
    limit: Literal["left", "right"] | None = None

    @model_validator(mode="after")
    def _one_kind(self) -> Step:
        if self.kind is None:
            raise FaultError(
                Words(
                    "此步应为三种之一；如写 {find: C, on: DC, from: E}、{join: C, to: BD, side: left} 或 "
                    "{limits: C, on: DC, crank: AB, K: 1.4, first: (380, -680) mm, limit: left}",
                    "this must be one of three sorts of stage; write e.g. {find: C, on: DC, from: E}, "
                    "{join: C, to: BD, side: left}, or {limits: C, on: DC, crank: AB, K: 1.4, "
                    "first: (380, -680) mm, limit: left}",
                ),
                code="spelling",
            )
        return self

    def told(self, count: int) -> Words:
        """What this stage does, of so many positions."""
        if self.find is not None:
            lies = Words.same("") if count > 2 else self._lies()
            return Words(
                f"构件 ${self.on}$ 上的铰链 ${self.find}$ 由杆 ${self.start}{self.find}$ 与 ${self.start}$ 相连"
                f"{lies.zh}",
                f"the bar ${self.start}{self.find}$ joins ${self.start}$ to the pin ${self.find}$ of link ${self.on}$"
                f"{lies.en}",
            )
        if self.join is not None and self.to is not None:
            one, two = self.to[0], self.to[1]
            side = Words("左", "left") if self.side == "left" else Words("右", "right")
            return Words(
                f"铰链 ${self.join}$ 由杆 ${self.join}{one}$、${self.join}{two}$ 与 ${one}$、${two}$ 相连，在由 "
                f"${one}$ 到 ${two}$ 的射线{side.zh}侧",
                f"the bars ${self.join}{one}$ and ${self.join}{two}$ join the pin ${self.join}$ to ${one}$ and "
                f"${two}$, on the {side.en} of the ray from ${one}$ to ${two}$",
            )
        limit = Words("左", "left") if self.limit == "left" else Words("右", "right")
        coupler = f"{(self.crank or '')[-1:]}{self.limits}"
        return Words(
            f"曲柄 ${self.crank}$ 经连杆 ${coupler}$ 带动摇杆 ${self.on}$ 摆动，${self.limits}_1$ 为铰链 "
            f"${self.limits}$ 的{limit.zh}极限位置，$K$ 为行程速比系数",
            f"the crank ${self.crank}$ makes the rocker ${self.on}$ swing through the coupler ${coupler}$; "
            f"${self.limits}_1$ is the {limit.en} limit position of its pin ${self.limits}$, $K$ the time ratio",
        )

    def _lies(self) -> Words:
        """Where the pin lies in the position that is kept."""
        if self.line is None:
            return Words(f"，${self.find}$ 在标线 ${self.on}$ 上", f", ${self.find}$ lying on its line ${self.on}$")
        return Words(
            f"，在位置 {self.onto}，${self.find}$ 位于直线 ${self.line}$ 上",
            f", ${self.find}$ lying on the line ${self.line}$ in position {self.onto}",
        )

    def given(self) -> tuple[tuple[str, str], ...]:
        """The limit position and K, where it has them."""
        if self.first is None or self.K is None:
            return ()
        return (f"{self.limits}_{{1}}", self.first.text), ("K", self.K.text)

    @property
    def kind(self) -> str | None:
        """What this stage does: find, join or limits."""
        given = {name for name in type(self).model_fields if getattr(self, name) is not None} - {"onto", "line"}
        return next((kind for kind, keys in _KINDS.items() if given == keys), None)


_KINDS = {
    "find": {"find", "on", "start"},
    "join": {"join", "to", "side"},
    "limits": {"limits", "on", "crank", "K", "first", "limit"},
}

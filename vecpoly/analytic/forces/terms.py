"""What stands in equations of equilibrium beside sums and products: the sense and the size of a quantity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...algebra.formula import Node, Row, Txt
from ..expr import THIN, Env, Expr, Values, bracketed


@dataclass(frozen=True, slots=True)
class Sense(Expr):
    """+1 or −1, as the body is positive or negative."""

    body: Expr

    @property
    def node(self) -> Node:
        return Row((Txt(f"sgn{THIN}"), bracketed(self.body)))

    def value(self, env: Env) -> Values:
        return np.sign(self.body.value(env))

    def parts(self) -> tuple[Expr, ...]:
        return (self.body,)


@dataclass(frozen=True, slots=True)
class Size(Expr):
    """The absolute value."""

    body: Expr

    @property
    def node(self) -> Node:
        return Row((Txt("|"), self.body.node, Txt("|")))

    def value(self, env: Env) -> Values:
        return np.abs(self.body.value(env))

    def parts(self) -> tuple[Expr, ...]:
        return (self.body,)

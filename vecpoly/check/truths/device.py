"""A device: its oracle answers under the keys of what is asked; its data are taken as they are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...devices.base import Device
from ...foundation.frozen import FrozenMap
from ...names import Rel
from ...oracle.devices.registry import device_answers
from ...problem.problem import Printed, Problem
from ..truth import ActsAt, Values, finite, knows, size_of


@knows(Device)
@dataclass(frozen=True)
class DeviceTruth:
    """The oracle's opinion of a device."""

    problem: Problem
    lines: Mapping[str, ActsAt] = FrozenMap({})
    nearby: tuple[Values, ...] = ()

    @property
    def likely(self) -> Mapping[str, float]:
        """What the data alone make likely."""
        return self.problem.device.likely

    @cached_property
    def values(self) -> Values:
        """Key → exact value, of all that is asked."""
        with np.errstate(invalid="ignore", divide="ignore"):
            found = device_answers(self.problem.device)
        device = self.problem.device
        return finite({ask.rel.key: found[ask.rel.key] for ask in self.problem.asks}, device.directions)

    def known(self, rel: Rel) -> None:
        """Nothing: a device's construction has no motion."""

    def behind(self) -> Callable[[Printed], float | None]:
        """Sizes behind printed answers, asked for or not."""
        found = device_answers(self.problem.device)
        return lambda printed: size_of(found[printed.rel.key]) if printed.rel else None

    def way(self) -> Callable[[Printed], complex | None]:
        """Directions printed of a device are not compared."""
        return lambda printed: None

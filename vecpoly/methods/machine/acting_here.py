from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ...board.construction import View
from ...mechanism.laws.acting import size_of
from ...names import At, omega
from ...plane import nominal
from ..desk import Desk
from ..kinematics.image import found_tip


@dataclass
class _S:
    desk: Desk

    def drive(self):
        return self.desk.mech.drive.position

    def speed(self, link, point, direction):
        tip = complex(nominal(found_tip(self.desk, View.VELOCITY, At(point, link))))
        v = (tip * np.exp(-1j * direction)).real
        return 0.0 if abs(v) < 1e-7 else v

    def spin(self, link):
        return float(nominal(self.desk.turns[omega(link)].value))

    def travelled(self, link, point, direction):
        x = (complex(nominal(self.desk.at[point])) * np.exp(-1j * direction)).real / self.desk.mm(1.0)
        return x - (-TEMP[0]), TEMP[1]


TEMP = [0.0, 1.0]


def acting_here(desk, loads):
    def one(load):
        return load if load.law is None else replace(load, size=float(size_of(load, _S(desk))), law=None)

    return replace(loads, forces=tuple(map(one, loads.forces)), moments=tuple(map(one, loads.moments))), {}

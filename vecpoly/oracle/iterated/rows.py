"""Joints as equations g(a, b) = 0 between two links, with their rates and partial derivatives, for Newton.

Every joint gives one complex gap whose two parts are its two scalar equations, both in m (an angle, the real part,
is multiplied by the mechanism's scale). `rate` and `accel` are g' and g'' for the links' present motion. `jac` holds
the derivatives with respect to (x, y, φ) of either link. Where a joint is `held`, the real part alone counts.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import ends
from ...mechanism.model import Circle, Joint, Mechanism, Prismatic, Rack, Revolute, Rolling, Side
from ..run import wrapped
from ..state import Body, Points, Reals

Jacobian = NDArray[np.complex128]  # positions × 3
Blocks = tuple[Jacobian, Jacobian]
TURN = np.array([0.0, 0.0, 1.0])


def _columns(x: Points | float, turn: Points) -> Jacobian:
    """∂/∂x, ∂/∂y, ∂/∂φ of a complex quantity that depends on the link's origin by the factor x."""
    columns: Jacobian = np.empty((*np.broadcast(x, turn).shape, 3), np.complex128)
    columns[..., 0], columns[..., 1], columns[..., 2] = x, 1j * x, turn
    return columns


def _arm(body: Body, local: complex) -> Points:
    """∂r/∂φ of the link's point."""
    return 1j * (body.unit * local)


def _mix(angle: NDArray[np.float64], place: NDArray[np.float64]) -> Jacobian:
    """Real part: the angle's equation; imaginary part: that of the place."""
    mixed: Jacobian = angle + 1j * place
    return mixed


@dataclass(frozen=True, slots=True)
class Pinned:
    """Revolute: r_a - r_b = 0."""

    a: str
    b: str
    at_a: complex
    at_b: complex
    held: bool = False
    rolls: bool = False

    def gap(self, a: Body, b: Body, ref_a: Body, ref_b: Body) -> Points:
        return a.point(self.at_a) - b.point(self.at_b)

    def rate(self, a: Body, b: Body) -> Points:
        return a.velocity_of(self.at_a) - b.velocity_of(self.at_b)

    def accel(self, a: Body, b: Body) -> Points:
        return a.acceleration_of(self.at_a) - b.acceleration_of(self.at_b)

    def jac(self, a: Body, b: Body) -> Blocks:
        return _columns(1.0, _arm(a, self.at_a)), _columns(-1.0, -_arm(b, self.at_b))


@dataclass(frozen=True, slots=True)
class Guided:
    """Prismatic, or gear on rack: ζ = e^{-iθ} (pin - origin) in the line of link a; Im ζ = offset.

    The angle's equation is φ_b - φ_a + roll Re ζ = const: turn for a slider (roll = 0), no slip for a gear
    (its angle counts from the reference).
    """

    a: str
    b: str
    origin: complex
    along: complex
    offset: float
    pin: complex
    scale: float
    turn: float = 0.0
    roll: float = 0.0
    held: bool = False

    @property
    def rolls(self) -> bool:
        return self.roll != 0.0

    def _local(self, a: Body, b: Body) -> tuple[Points, Points]:
        back = (a.unit * self.along).conj()
        return back, b.point(self.pin) - a.point(self.origin)

    def gap(self, a: Body, b: Body, ref_a: Body, ref_b: Body) -> Points:
        back, ray = self._local(a, b)
        local = back * ray
        if self.roll:
            back_0, ray_0 = self._local(ref_a, ref_b)
            advance = local.real - (back_0 * ray_0).real
            angle = _turn(b) - _turn(ref_b) - _turn(a) + _turn(ref_a) + self.roll * advance
        else:
            angle = np.angle(b.unit * a.unit.conj() * complex(np.exp(-1j * self.turn)))
        return _mix(self.scale * angle, local.imag - self.offset)

    def _derived(self, local: Points, angle: Reals) -> Points:
        return _mix(self.scale * (angle + self.roll * local.real), local.imag)

    def rate(self, a: Body, b: Body) -> Points:
        back, ray = self._local(a, b)
        speed = b.velocity_of(self.pin) - a.velocity_of(self.origin)
        return self._derived(back * (speed - 1j * a.omega * ray), b.omega - a.omega)

    def accel(self, a: Body, b: Body) -> Points:
        back, ray = self._local(a, b)
        speed = b.velocity_of(self.pin) - a.velocity_of(self.origin)
        pull = b.acceleration_of(self.pin) - a.acceleration_of(self.origin)
        spin = 1j * a.alpha + a.omega * a.omega
        return self._derived(back * (pull - 2j * a.omega * speed - spin * ray), b.alpha - a.alpha)

    def jac(self, a: Body, b: Body) -> Blocks:
        back, ray = self._local(a, b)
        of_a = _columns(-back, -back * (_arm(a, self.origin) + 1j * ray))
        of_b = _columns(back, back * _arm(b, self.pin))
        return (
            _mix(self.scale * (self.roll * of_a.real - TURN), of_a.imag),
            _mix(self.scale * (self.roll * of_b.real + TURN), of_b.imag),
        )


@dataclass(frozen=True, slots=True)
class Meshed:
    """Gear on gear: with ln(c_b - c_a) = ln ρ + iψ: ln ρ = ln reach and φ_b + κφ_a - (1 + κ)ψ = const."""

    a: str
    b: str
    at_a: complex
    at_b: complex
    reach: float
    ratio: float
    scale: float
    held: bool = False
    rolls: bool = True

    def _ray(self, a: Body, b: Body) -> Points:
        return b.point(self.at_b) - a.point(self.at_a)

    def _join(self, log: Points, angle: Reals) -> Points:
        return _mix(self.scale * (angle - (1 + self.ratio) * log.imag), self.reach * log.real)

    def gap(self, a: Body, b: Body, ref_a: Body, ref_b: Body) -> Points:
        ray, ray_0 = self._ray(a, b), self._ray(ref_a, ref_b)
        log = np.log(np.abs(ray) / self.reach) + 1j * wrapped(np.angle(ray) - np.angle(ray_0))
        angle = _turn(b) - _turn(ref_b) + self.ratio * (_turn(a) - _turn(ref_a))
        return self._join(log, angle)

    def rate(self, a: Body, b: Body) -> Points:
        speed = b.velocity_of(self.at_b) - a.velocity_of(self.at_a)
        return self._join(speed / self._ray(a, b), b.omega + self.ratio * a.omega)

    def accel(self, a: Body, b: Body) -> Points:
        ray = self._ray(a, b)
        speed = b.velocity_of(self.at_b) - a.velocity_of(self.at_a)
        pull = b.acceleration_of(self.at_b) - a.acceleration_of(self.at_a)
        return self._join(pull / ray - (speed / ray) ** 2, b.alpha + self.ratio * a.alpha)

    def jac(self, a: Body, b: Body) -> Blocks:
        ray = self._ray(a, b)
        of_a = _columns(-1 / ray, -_arm(a, self.at_a) / ray)
        of_b = _columns(1 / ray, _arm(b, self.at_b) / ray)
        arm = 1 + self.ratio
        return (
            _mix(self.scale * (self.ratio * TURN - arm * of_a.imag), self.reach * of_a.real),
            _mix(self.scale * (TURN - arm * of_b.imag), self.reach * of_b.real),
        )


Row = Pinned | Guided | Meshed


def _turn(body: Body) -> Reals:
    assert body.turn is not None
    return body.turn


def row(mech: Mechanism, joint: Joint, held: bool) -> Row:
    """The joint's equations."""
    a, b = (mech.link(name) for name in ends(joint))
    match joint:
        case Revolute():
            return Pinned(a.name, b.name, a.points[joint.point], b.points[joint.point])
        case Prismatic():
            along, turn = complex(np.exp(1j * joint.direction)), joint.direction + joint.turn
            pin = b.points[joint.pin]
            return Guided(a.name, b.name, joint.origin, along, joint.offset, pin, mech.scale, turn)
        case Rolling(on=Rack() as rack):
            return _on_rack(mech, joint, rack, held)
        case Rolling(on=Circle() as wheel):
            return _on_gear(mech, joint, wheel, held)
    raise AssertionError


def _on_rack(mech: Mechanism, joint: Rolling, rack: Rack, held: bool) -> Guided:
    """The gear's centre runs parallel to the pitch line, and the gear turns as it goes."""
    gear, body = (mech.link(name) for name in ends(joint))
    along, side = complex(np.exp(1j * rack.direction)), 1.0 if joint.side is Side.LEFT else -1.0
    radius, centre = joint.gear.radius, gear.points[joint.gear.centre]
    return Guided(
        body.name, gear.name, rack.origin, along, side * radius, centre, mech.scale, roll=side / radius, held=held
    )


def _on_gear(mech: Mechanism, joint: Rolling, wheel: Circle, held: bool) -> Meshed:
    """The centres keep their distance, and the gears turn by their ratio."""
    gear, other = (mech.link(name) for name in ends(joint))
    ratio = wheel.radius / joint.gear.radius * (-1 if joint.internal else 1)
    small, large = sorted((wheel.radius, joint.gear.radius))
    reach = large - small if joint.internal else large + small
    centres = other.points[wheel.centre], gear.points[joint.gear.centre]
    return Meshed(other.name, gear.name, *centres, reach, ratio, mech.scale, held)

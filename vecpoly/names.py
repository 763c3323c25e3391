"""One key for one quantity: `Rel` joins the reading, the oracle's answer, the rubric and the answer file.

ASCII forms (the textbook's symbol in brackets):
``v_C`` [v_C], ``v_C2`` [v_{C2}: point C of link 2], ``v_CB`` [v_{CB}: C to B, one link], ``v_B3B2`` [v_{B3B2}:
coincident points of links 3 and 2], ``an_CB`` [a^n_{CB}], ``at_CB`` [a^t_{CB}], ``an_C`` [a^n_C, about the pivot],
``ak_B3B2`` [a^k_{B3B2}, Coriolis], ``ar_B3B2`` [a^r_{B3B2}], ``omega_3`` [ω_3], ``alpha_3`` [α_3], ``p_X`` [place]."""

from __future__ import annotations

from dataclasses import field
from enum import StrEnum

from .errors import UnknownNameError
from .foundation.indices import LETTER
from .foundation.patterns import pattern
from .foundation.slotted import dataclass
from .words import Words


class Kind(StrEnum):
    """What a symbol stands for; the value is the ASCII stem of the key."""

    P = "p"
    V = "v"
    A = "a"
    AN = "an"
    AT = "at"
    AK = "ak"
    AR = "ar"
    OMEGA = "omega"
    ALPHA = "alpha"

    @property
    def is_vector(self) -> bool:
        return self not in (Kind.OMEGA, Kind.ALPHA)

    @property
    def unit(self) -> str:
        """SI unit as printed: m, m/s, m/s², rad/s, rad/s²."""
        return _UNIT[self]

    @property
    def stem(self) -> str:
        """The symbol before its subscript, in the notation of `formula`: v, a^n, ω."""
        return _STEM[self]


_UNIT = {
    Kind.P: "m",
    Kind.V: "m/s",
    Kind.A: "m/s^2",
    Kind.AN: "m/s^2",
    Kind.AT: "m/s^2",
    Kind.AK: "m/s^2",
    Kind.AR: "m/s^2",
    Kind.OMEGA: "rad/s",
    Kind.ALPHA: "rad/s^2",
}
_STEM = {
    Kind.P: "r",
    Kind.V: "v",
    Kind.A: "a",
    Kind.AN: "a^n",
    Kind.AT: "a^t",
    Kind.AK: "a^k",
    Kind.AR: "a^r",
    Kind.OMEGA: "ω",
    Kind.ALPHA: "α",
}


@dataclass(frozen=True, slots=True)
class At:
    """A point, and on which link it is thought (empty where its letter alone tells).

    number: how the link is printed where it is the frame, whose number is one more than the highest.
    """

    point: str
    link: str = ""
    number: str = field(default="", compare=False)

    def __str__(self) -> str:
        return self.point + (self.number or self.link)


@dataclass(frozen=True, slots=True)
class Rel:
    """One quantity: kind, point (or link for ω, α) and, for relative vectors, the reference point."""

    kind: Kind
    to: At
    ref: At | None = None

    @property
    def key(self) -> str:
        """The ASCII form, e.g. ``ak_B3B2``."""
        body = self.to.link if not self.kind.is_vector else f"{self.to}{self.ref or ''}"
        return f"{self.kind.value}_{body}"

    @property
    def symbol(self) -> str:
        """The textbook's symbol in the notation of `formula`: ``a^n_{CB}``, ``ω_2``."""
        body = self.to.link if not self.kind.is_vector else f"{self.to}{self.ref or ''}"
        return f"{self.kind.stem}_{{{body}}}"

    @property
    def unit(self) -> str:
        """SI unit as printed."""
        return self.kind.unit

    @property
    def is_vector(self) -> bool:
        """Whether its value is a vector."""
        return self.kind.is_vector

    def __str__(self) -> str:
        return self.key


class Sort(StrEnum):
    """What a named quantity belongs to. A key's letters do not tell: P_r may be a load, P_13 is a centre."""

    PLAIN = "plain"  # of a force analysis, a device, a structure
    CENTRE = "centre"  # the place of an instant centre
    CENTRE_SPEED = "centre speed"  # the velocity that both links have there
    RATIO = "ratio"  # of two angular velocities, by centres
    LIMIT = "limit"  # an angle of the crank at which a led point stands still
    SPOT = "spot"  # a point found from curvatures: the inflection pole, the centre of curvature of a path
    CURVED = "curved"  # a radius, a diameter, an angle found likewise
    REDUCED = "reduced"  # of the equivalent link that stands for a whole machine, of its flywheel, of its motion
    PRESSURE = "pressure"  # a pressure angle, or a transmission angle, in one position
    BALANCE = "balance"  # of counterweights that balance the forces of a linkage


@dataclass(frozen=True, slots=True)
class Named:
    """A quantity with a name of its own: a load F, a reaction R_12, an efficiency eta, a limit angle.

    key: ASCII; symbol: the textbook's, in the notation of `formula` (``R_{12}``); unit: as printed, SI throughout but
    for `deg`, `mm` and `kW`. sort: what it belongs to; solution: of several, its number. is_size: of either sign.
    """

    key: str
    symbol: str
    unit: str
    is_vector: bool = False
    sort: Sort = Sort.PLAIN
    solution: int = 0
    is_size: bool = False

    @property
    def is_central(self) -> bool:
        """Whether it is found from instant centres."""
        return self.sort in (Sort.CENTRE, Sort.CENTRE_SPEED, Sort.RATIO, Sort.LIMIT)

    @property
    def is_curved(self) -> bool:
        """Whether it is found from the curvatures of paths."""
        return self.sort in (Sort.SPOT, Sort.CURVED)

    @property
    def is_reduced(self) -> bool:
        """Whether it is found from the mechanism as a machine: its equivalent link, its flywheel, its motion."""
        return self.sort is Sort.REDUCED

    @property
    def is_pressure(self) -> bool:
        """Whether it is a pressure angle, or a transmission angle."""
        return self.sort is Sort.PRESSURE

    def __str__(self) -> str:
        return self.key


Key = Rel | Named


def is_centre(key: Key) -> bool:
    """Whether the quantity is the place of an instant centre, P_13."""
    return isinstance(key, Named) and key.sort is Sort.CENTRE


def is_place(key: Key) -> bool:
    """Whether the quantity is a place: of a point, p_F, of an instant centre, P_13, of a centre of curvature, p_OE."""
    return key.kind is Kind.P if isinstance(key, Rel) else is_centre(key) or key.sort is Sort.SPOT


def reaction(by: str, on: str) -> Named:
    """R_12: the force of link 1 on link 2, by their printed numbers; R_1_11 (R_{1,11}) where one has two digits."""
    long = any(len(number) > 1 and number.isdigit() for number in (by, on))
    key, symbol = (f"{by}_{on}", f"{by},{on}") if long else (f"{by}{on}", f"{by}{on}")
    return Named(f"R_{key}", f"R_{{{symbol}}}", "N", True)


def written_unit(unit: str) -> str:
    """A unit as it is written by hand: m/s^2 → m/s², deg → °; yes and no have none."""
    return {"deg": "°", "yes/no": ""}.get(unit, unit.replace("^2", "²"))


_POINT = rf"({LETTER})(\d*)"
_VECTOR = pattern(rf"^(p|v|a|an|at|ak|ar)_{_POINT}(?:{_POINT})?$")
_NAMED_POINT = pattern(rf"^p_({LETTER}\d*)$")
_ANGULAR, _LONG = pattern(r"^(omega|alpha)_(\w+)$"), pattern(r"([A-Za-z])([a-z]+\d*)")


def subscripted(letter: str) -> str:
    """C2 as printed: C_2; a plain letter stays itself, and one with a subscript; Qz4 is Q_{z4}."""
    if (whole := _LONG.fullmatch(letter)) is not None:
        return f"{whole[1]}_{{{whole[2]}}}"
    bare = letter.rstrip("0123456789")
    return f"{bare}_{letter[len(bare) :]}" if letter != bare and not bare.endswith("_") else letter


def ascii_key(symbol: str) -> str:
    """The ASCII form of a printed symbol: ``a^n_{CB}`` is ``an_CB``, ``ω_2`` is ``omega_2``."""
    return symbol.translate(_ASCII)


_ASCII = str.maketrans(
    {"^": None, "{": None, "}": None, "ω": "omega", "α": "alpha", "γ": "gamma", "Δ": "d", "μ": "mu", "′": "'"}
)


def parse_rel(text: str) -> Rel:
    """Read an ASCII key such as ``v_E``, ``ak_B3B2``, ``omega_2``. Raises UnknownNameError when the text is no such
    key."""
    if m := _ANGULAR.match(text):
        return Rel(Kind(m[1]), At("", m[2]))
    if m := _NAMED_POINT.match(text):
        return Rel(Kind.P, At(m[1]))
    if m := _VECTOR.match(text):
        ref = At(m[4], m[5] or "") if m[4] else None
        return Rel(Kind(m[1]), At(m[2], m[3] or ""), ref)
    raise UnknownNameError(
        Words(
            f"“{text}”不是可识别的符号；应写 v_E、a_E、v_CB、an_CB、at_CB、ak_B3B2、omega_2 或 alpha_2",
            f"'{text}' is no symbol; write v_E, a_E, v_CB, an_CB, at_CB, ak_B3B2, omega_2 or alpha_2",
        )
    )


def omega(link: str) -> Rel:
    """ω of a link."""
    return Rel(Kind.OMEGA, At("", link))


def alpha(link: str) -> Rel:
    """α of a link."""
    return Rel(Kind.ALPHA, At("", link))

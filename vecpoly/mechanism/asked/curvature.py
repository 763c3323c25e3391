"""What may be asked of the kinematic geometry of one moving link, by key.

``W_2`` the inflection pole of link 2, ``delta_2`` the diameter of its inflection circle, ``Wr_2`` the return pole;
``U_2`` Ball's point;
``p_OE``, ``rho_E`` the centre and the radius of curvature of the path of its point E; ``lambda_2`` the angle between
the collineation axis and the line of the link's two pins (Freudenstein); ``L_f2``, ``L_m2`` the fixed and the moving
centrode, stepped off in chords.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from math import degrees

from ...errors import NotAskedError
from ...foundation.slotted import dataclass
from ...names import Named, Sort
from ...words import Words
from ..model import FRAME, Mechanism
from .centres import centre


class Way(StrEnum):
    """By which construction the inflection circle and the centres of curvature are found."""

    BOBILLIER = "bobillier"
    EULER_SAVARY = "euler-savary"
    HARTMANN = "hartmann"
    ARONHOLD = "aronhold"


@dataclass(frozen=True, slots=True, kw_only=True)
class Centrodes:
    """Both centrodes of a link, drawn through this many positions of the drive from `start` to `end` (rad)."""

    link: str
    start: float
    end: float
    positions: int

    @property
    def drive(self) -> tuple[float, ...]:
        """The positions of the drive (rad)."""
        step = (self.end - self.start) / (self.positions - 1)
        return tuple(self.start + k * step for k in range(self.positions))


@dataclass(frozen=True, slots=True, kw_only=True)
class Curvature:
    """That curvatures are asked: of which link, by which construction, with which centrodes."""

    link: str
    way: Way = Way.BOBILLIER
    centrodes: Centrodes | None = None


def inflection_pole(mech: Mechanism, link: str) -> Named:
    """W_2: the point of the inflection circle opposite the instant centre."""
    return Named(f"W_{mech.number(link)}", f"W_{{{mech.number(link)}}}", "m", True, Sort.SPOT)


def diameter(mech: Mechanism, link: str) -> Named:
    """delta_2: the diameter PW of the inflection circle."""
    return Named(f"delta_{mech.number(link)}", f"δ_{{{mech.number(link)}}}", "m", sort=Sort.CURVED)


def return_pole(mech: Mechanism, link: str) -> Named:
    """Wr_2: the mirror image of the inflection pole in the pole, opposite it on the return circle."""
    return Named(f"Wr_{mech.number(link)}", f"W^{{r}}_{{{mech.number(link)}}}", "m", True, Sort.SPOT)


def ball_point(mech: Mechanism, link: str) -> Named:
    """U_2: Ball's point, whose path meets its tangent in four points that fall together: κ = 0 and dκ/ds = 0."""
    return Named(f"U_{mech.number(link)}", f"U_{{{mech.number(link)}}}", "m", True, Sort.SPOT)


def collineation(mech: Mechanism, link: str) -> Named:
    """lambda_2: the angle (deg, to 90) between the collineation axis and the line of the link's pins."""
    return Named(f"lambda_{mech.number(link)}", f"λ_{{{mech.number(link)}}}", "deg", sort=Sort.CURVED)


def path_centre(point: str) -> Named:
    """p_OE: the centre of curvature of the path of E."""
    return Named(f"p_O{point}", f"O_{{{point}}}", "m", True, Sort.SPOT)


def radius(point: str) -> Named:
    """rho_E: the radius of curvature of the path of E."""
    return Named(f"rho_{point}", f"ρ_{{{point}}}", "m", sort=Sort.CURVED)


def centrode_lengths(mech: Mechanism, link: str) -> tuple[Named, Named]:
    """L_f2, L_m2: the chords of the fixed and of the moving centrode."""
    n = mech.number(link)
    fixed, moving = (Named(f"L_{kind}{n}", f"L_{{{kind}{n}}}", "m", sort=Sort.CURVED) for kind in "fm")
    return fixed, moving


def of_link(mech: Mechanism, link: str) -> dict[str, Named]:
    """Everything that may be asked of one link, by its key."""
    points = mech.link(link).points
    found = (
        centre(mech, link, FRAME),
        inflection_pole(mech, link),
        diameter(mech, link),
        return_pole(mech, link),
        ball_point(mech, link),
        collineation(mech, link),
        *(path_centre(point) for point in points),
        *(radius(point) for point in points),
    )
    return {named.key: named for named in found}


def asked_points(mech: Mechanism, link: str, keys: Iterable[str]) -> tuple[str, ...]:
    """The points of the link of whose paths something is asked."""
    wanted = set(keys)
    return tuple(p for p in mech.link(link).points if wanted & {path_centre(p).key, radius(p).key})


def cusp(name: str) -> NotAskedError:
    """The point is the pole: it rests, and its path has no curvature."""
    return NotAskedError(
        Words(
            f"{name} 与绝对瞬心重合，其轨迹在此为尖点，没有曲率半径；请从 find 中去掉",
            f"{name} is the pole itself: its path has a cusp here and no radius of curvature; leave it out of `find`",
        ),
        code="cusp",
    )


def inflected(name: str) -> NotAskedError:
    """The point lies on the inflection circle: its path is straight here."""
    return NotAskedError(
        Words(
            f"{name} 在拐点圆上，ρ = ∞：其轨迹在此为拐点或直线，曲率中心在无穷远处；请从 find 中去掉",
            f"{name} lies on the inflection circle, ρ = ∞: its path has an inflection here or is straight, and the "
            "centre of curvature is at infinity; leave it out of `find`",
        ),
        code="inflection",
    )


def no_ball(mech: Mechanism, link: str) -> NotAskedError:
    """Ball's point is not one point here, or lies at infinity."""
    number = mech.number(link)
    return NotAskedError(
        Words(
            f"构件 {number} 此时没有确定的鲍尔点（拐点圆上处处为鲍尔点，或该点即绝对瞬心，或在无穷远处）；"
            "请另取原动件位置，或从 find 中去掉",
            f"link {number} has no Ball point here (every point of its inflection circle is one, or it is the pole or "
            "at infinity); choose another input position, or leave it out of `find`",
        ),
        code="no-ball-point",
    )


def between(mech: Mechanism, asked: Centrodes) -> Words:
    """From which position of the drive to which."""
    drive = mech.drive
    factor, unit = (1e3, " mm") if drive.slide else (degrees(1.0), "°")
    start, end = (f"{round(factor * at, 9):.5g}".replace("-", "−") for at in (asked.start, asked.end))
    return Words(f"${drive.symbol}$ = {start}{unit} 到 {end}{unit}", f"${drive.symbol}$ = {start}{unit} to {end}{unit}")

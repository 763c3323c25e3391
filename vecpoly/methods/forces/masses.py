"""Masses and moments of inertia of the links: given, or computed for round bars, m = ρ π d² l / 4 and J = m l² / 12
(what that leaves out of thick ones is said); and weights."""

from __future__ import annotations

from math import pi

from ...algebra.formula import Txt
from ...algebra.quantity import Expr, Quantity, magnitude, number
from ...board.construction import View
from ...mechanism.asked.forces import mass_named
from ...mechanism.loads import GRAVITY, Mass, Rod
from ...names import At, Named
from ...plane import Reals, nominal
from ...words import Words
from .acting import Acting
from .readings import keep_value
from .state import Statics

THICK = 0.05  # of the moment of inertia: what a thin rod's may leave out


def masses(st: Statics) -> None:
    """Keep mass (kg) and moment of inertia (kg·m²) of every link as readings;
    write out how those of bars follow from their section."""
    rods = [mass for mass in st.loads.masses if mass.rod is not None]
    if rods:
        links, links_en = "、".join(mass.link for mass in rods), ", ".join(mass.link for mass in rods)
        st.board.step(
            Words(
                f"构件 {links} 为圆截面杆，按细长杆求质量和对质心的转动惯量：",
                f"Treat the round bar{'s' if len(rods) > 1 else ''} {links_en} as slender to find mass and moment of "
                "inertia about the centre of mass:",
            )
        )
    for mass in st.loads.masses:
        _keep(st, mass)
    for mass in rods:
        if mass.rod is not None and mass.rod.thickness > THICK:
            st.board.step(_thick(st, mass, mass.rod))


def _thick(st: Statics, mass: Mass, rod: Rod) -> Words:
    """That a bar is no slender rod, what it has as a cylinder, and whether that matters."""
    ratio, times = number(rod.diameter / rod.length, 2), number(1 + rod.thickness, 3)
    found = number(mass.inertia * (1 + rod.thickness), 3)
    told = Words(
        f"构件 {mass.link} 的 $d$/$l$ = {ratio}，不是细长杆；按圆柱计，$J$ = $m(3r^2 + l^2)/12$ = {found} kg·m²，"
        f"为上值的 {times} 倍。",
        f"Link {mass.link}, of $d$/$l$ = {ratio}, is no slender rod: as a cylinder it has $J$ = $m(3r^2 + l^2)/12$ = "
        f"{found} kg·m², {times} times that value.",
    )
    drive = st.desk.mech.drive
    if drive.link != mass.link or drive.slide or drive.accel:
        return told
    return told + Words(
        "该构件匀速转动，惯性力偶矩为零，其余结果不受影响。",
        " It turns uniformly and has no inertia couple, so nothing else depends on it.",
    )


def _keep(st: Statics, mass: Mass) -> None:
    weight, inertia = mass_named(mass)
    m: Expr = magnitude(weight.symbol, mass.mass, weight.unit)
    j: Expr = magnitude(inertia.symbol, mass.inertia, inertia.unit)
    if mass.rod is not None:
        m, j = _of_rod(mass.link, mass.rod, mass.mass)
        st.board.compute(weight.symbol, m, weight.unit)
        st.board.compute(inertia.symbol, j, inertia.unit)
    keep_value(st, weight, float(nominal(m.value)), m)
    keep_value(st, inertia, float(nominal(j.value)), j)


def _of_rod(link: str, rod: Rod, mass: float) -> tuple[Expr, Expr]:
    """ρ π d² l / 4, m l² / 12."""
    length, diameter = magnitude(f"l_{link}", rod.length, "m"), magnitude(f"d_{link}", rod.diameter, "m")
    section = magnitude("ρ", rod.density, "kg/m^3") * magnitude("π", pi, "") * diameter.squared()
    return section * length / _plain(4), magnitude(f"m_{link}", mass, "kg") * length.squared() / _plain(12)


def _plain(number: int) -> Quantity:
    return Quantity(Txt(str(number)), float(number), "")


def weight_named(mass: Mass) -> Named:
    """G_2 (N)."""
    return Named(f"G_{mass.link}", f"G_{{{mass.link}}}", "N", True)


def weight_force(st: Statics, mass: Mass) -> None:
    """G = m g, down through S."""
    named = weight_named(mass)
    s = st.desk.name(At(mass.centre))
    st.board.step(
        Words(
            f"构件 {mass.link} 的重力过质心 ${s}$ 竖直向下。",
            f"The weight of link {mass.link} acts straight down through ${s}$.",
        ),
        View.MECHANISM,
    )
    size = st.board.compute(
        named.symbol, magnitude(f"m_{mass.link}", mass.mass, "kg") * magnitude("g", GRAVITY, "m/s^2"), "N"
    )
    _hang(st, mass, size.value)


def weights(st: Statics) -> None:
    """The weights as `weight_force` keeps them, without a word: where they were told already, or on scratch paper."""
    for mass in st.loads.masses if st.loads.weight else ():
        _hang(st, mass, mass.mass * GRAVITY)


def _hang(st: Statics, mass: Mass, size: Reals) -> None:
    acting = Acting(
        named=weight_named(mass),
        vector=-1j * st.mm(size),
        at=st.desk.where(At(mass.centre, mass.link)),
        size=f"$m_{mass.link} g$",
    )
    st.inertia.setdefault(mass.link, []).append(acting)

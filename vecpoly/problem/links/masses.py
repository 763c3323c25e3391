"""Masses as written: ``2: {mass: 3 kg, inertia: 0.02 kg*m^2, centre: {along: BC, at: 100 mm}}``, or of a round bar."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TypeVar

from ...errors import FaultError
from ...foundation.slotted import replace
from ...mechanism.loads import Mass, Rod
from ...mechanism.model import FRAME, ByOffsets
from ...units.reading import Dim, Quantity, positive, read
from ...words import Words
from ..loads.laws.law_data import written
from ..problem import Datum
from ..schema.faults import Faults, not_on_link
from ..schema.models import MassSpec, ProblemSpec, RodSpec
from .bodies import Bodies, frame_number
from .draft import Draft, letters_of
from .places import place

Found = TypeVar("Found")


def read_masses(spec: ProblemSpec, bodies: Bodies, faults: Faults) -> tuple[tuple[Mass, ...], tuple[Datum, ...]]:
    """The masses, whose centres become lettered points S2 of their links, and their data for 已知."""
    found: list[tuple[Mass, tuple[Datum, ...]]] = []
    for link, one in spec.masses.items():
        with faults.at("masses", link):
            found.append(_mass(link, one, bodies))
    found = _told_apart(found)
    masses, data = [mass for mass, _ in found], [one for _, told in found for one in told]
    bars = [mass for mass in masses if mass.rod is not None]
    return tuple(masses), (*_of_one_steel(data), *([Datum(words=_bar_words(bars, bodies))] if bars else []))


def _told_apart(found: list[tuple[Mass, tuple[Datum, ...]]]) -> list[tuple[Mass, tuple[Datum, ...]]]:
    """Moments of inertia about one letter under symbols of their own."""
    centres = [mass.centre for mass, _ in found if mass.inertia]
    apart: list[tuple[Mass, tuple[Datum, ...]]] = []
    for mass, told in found:
        own = replace(mass, shared=centres.count(mass.centre) > 1)
        symbols = {mass.inertia_symbol: own.inertia_symbol}
        apart.append((own, tuple(replace(one, symbol=symbols.get(one.symbol, one.symbol)) for one in told)))
    return apart


def _of_one_steel(data: Sequence[Datum]) -> Iterator[Datum]:
    """The density of all round bars once, where it is one."""
    densities = [one for one in data if one.symbol.startswith("ρ")]
    same = len(densities) > 1 and len({one.si for one in densities}) == 1
    for one in data:
        if one not in densities or not same:
            yield one
        elif one is densities[0]:
            yield replace(one, symbol="ρ")


def _mass(link: str, spec: MassSpec, bodies: Bodies) -> tuple[Mass, tuple[Datum, ...]]:
    if link in (FRAME, frame_number(bodies)):
        raise FaultError(
            Words(
                f"构件 {link} 是机架，其质量不起作用；请去掉",
                f"link {link} is the frame: its mass has no effect; leave it out",
            )
        )
    draft = bodies.draft(link)
    if spec.rod is not None:
        _refuse_beside_rod(spec)
        return _within("rod", partial(_rod, draft, spec.rod))
    if spec.mass is None:
        raise FaultError(
            Words(
                "缺少质量；如写 mass: 3 kg，或 rod: {diameter: 40 mm, density: 7800 kg/m^3}",
                "the mass is missing; write e.g. mass: 3 kg, or rod: {diameter: 40 mm, density: 7800 kg/m^3}",
            ),
            code="missing",
        )
    mass = _within("mass", lambda: positive(spec.mass, Dim.MASS))
    inertia = _within("inertia", lambda: _inertia(spec.inertia))
    centre = _within("centre", lambda: _centre(draft, spec.centre))
    data = [Datum(symbol=f"m_{link}", si=mass.si, text=written(mass.text))]
    if spec.inertia is not None:
        data.append(Datum(symbol=f"J_{{{centre}}}", si=inertia.si, text=written(inertia.text)))
    if centre != f"S{link}":
        data.append(
            Datum(
                words=Words(f"构件 {link} 的质心在 ${centre}$", f"the centre of mass of link {link} is at ${centre}$")
            )
        )
    return Mass(link=link, mass=mass.si, inertia=inertia.si, centre=centre), tuple(data)


def _refuse_beside_rod(spec: MassSpec) -> None:
    rivals = [key for key in ("mass", "inertia", "centre") if getattr(spec, key) is not None]
    if rivals:
        raise FaultError(
            Words(
                f"圆杆的质量、转动惯量和质心由尺寸算出；请去掉 {'、'.join(rivals)}，或去掉 rod",
                f"the mass, inertia and centre of a round bar follow from it; leave out {' and '.join(rivals)}, or rod",
            ),
            code="contradiction",
        )


def _within(key: str, act: Callable[[], Found]) -> Found:
    try:
        return act()
    except FaultError as fault:
        raise fault.under(key) from None


def _inertia(text: str | None) -> Quantity:
    quantity = read("0" if text is None else text, Dim.INERTIA)
    if quantity.si < 0:
        raise FaultError(
            Words(
                f"“{text}”不得为负；如写 {Dim.INERTIA.example}",
                f"'{text}' must not be negative; write e.g. {Dim.INERTIA.example}",
            ),
            code="out-of-range",
        )
    return quantity


def _centre(draft: Draft, written_as: object) -> str:
    """The letter of the centre of mass: one of the link's, or S2, set out as any other point."""
    if isinstance(written_as, str):
        if written_as not in draft.held:
            raise not_on_link(written_as, draft.name, draft.held)
        return written_as
    if written_as is None and len(draft.held) == 1:
        return next(iter(draft.held))
    if written_as is None:
        first, second = list(draft.held)[:2]
        raise FaultError(
            Words(
                f"构件 {draft.name} 的质心在哪里？如写 centre: {{along: {first}{second}, at: 100 mm}}",
                f"where is the centre of mass of link {draft.name}? write e.g. centre: {{along: "
                f"{first}{second}, at: 100 mm}}",
            ),
            code="missing",
        )
    letter = f"S{draft.name}"
    place(draft, letter, written_as)
    return letter


def _rod(draft: Draft, spec: RodSpec) -> tuple[Mass, tuple[Datum, ...]]:
    if len(draft.held) < 2:
        raise FaultError(
            Words(
                f"构件 {draft.name} 只有点 {next(iter(draft.points))}，没有长度；请给出 mass、inertia 和 centre",
                f"link {draft.name} has only the point {next(iter(draft.points))} and so no length; give mass, "
                "inertia and centre",
            )
        )
    first, second = _within("along", lambda: _ends(draft, spec.along))
    diameter = _within("diameter", lambda: positive(spec.diameter))
    density = _within("density", lambda: positive(spec.density, Dim.DENSITY))
    span = draft.points[second] - draft.points[first]
    bar = Rod(diameter=diameter.si, density=density.si, length=abs(span))
    letter, middle = f"S{draft.name}", draft.points[first] + span / 2
    draft.points[letter] = middle
    draft.placements.append(ByOffsets(point=letter, base=(first, second), along=abs(span) / 2))
    mass = Mass(link=draft.name, mass=bar.mass, inertia=bar.inertia(bar.mass), centre=letter, rod=bar)
    told = ((f"d_{draft.name}", diameter), (f"ρ_{draft.name}", density))
    return mass, tuple(Datum(symbol=symbol, si=one.si, text=written(one.text)) for symbol, one in told)


def _ends(draft: Draft, text: str | None) -> tuple[str, str]:
    first, second = letters_of(text) if text else tuple(draft.held)[:2]
    if first == second:
        raise FaultError(Words(f"圆杆的两端都是 {first}", f"a bar from {first} to itself"))
    for letter in (first, second):
        if letter not in draft.held:
            raise not_on_link(letter, draft.name, draft.held)
    return first, second


def _bar_words(bars: Sequence[Mass], bodies: Bodies) -> Words:
    """The round bars, all at once; what follows from them is worked out in the solution."""
    links, spots, lines = [one.link for one in bars], [], []
    for one in bars:
        ends = next(p.base for p in bodies.draft(one.link).placements if p.point == one.centre)
        spots.append(f"$S_{one.link}$")
        lines.append(f"${''.join(ends)}$")
    many = len(bars) > 1
    return Words(
        f"构件 {'、'.join(links)} 为圆截面杆，质心 {'、'.join(spots)} {'分别' * many}在 {'、'.join(lines)} 的中点",
        f"link{'s' * many} {', '.join(links)} {'are' if many else 'is a'} round bar{'s' * many} with the "
        f"centre{'s' * many} of mass {', '.join(spots)} in the middle of {', '.join(lines)}",
    )

"""The couple polygon about a reference plane: drawn along the products, reversed on the other side; closed by the two
unknowns in one of the four ways."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

import numpy as np

from ....algebra.quantity import Quantity
from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....devices.balancing.rotor import Rotor
from ....devices.balancing.sought import couple_of, no_polygon, parallel_couples, reference, unknowns
from ....errors import AssemblyError, DeadPointError, EquilibriumError
from ....foundation.slotted import dataclass
from ....plane import Line, Points, Reals, nominal
from ....words import Words
from ..bench import Bench
from .polygon import Laid, heading, summed

TURNED = Words("力偶矢量转过 90°，沿 $W$ 的方向画", "The couple vectors are turned by 90°, so that they lie along $W$")
REVERSED = Words(
    "；在参考平面左侧（$z$ < 0）的反向", "; those to the left of the reference plane ($z$ < 0) are reversed"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Solution:
    """Of every mass sought its couple on paper, with its ends and their letters."""

    vectors: Mapping[str, Points]
    ends: Mapping[str, tuple[Points, Points]]
    letters: Mapping[str, str]


def close_couples(bench: Bench, rotor: Rotor, place: Pane, couples: Mapping[str, Quantity]) -> list[Solution]:
    """Lay the known couples off, then close the polygon: one solution, or two mirrored ones."""
    board = bench.board
    names, here = list(dict.fromkeys(name for name, _ in unknowns(rotor.masses))), _here(rotor)
    board.step(
        Words(
            "按 $μ_{Wl}$ 画力偶多边形：先首尾相接画出大小、方向均已知的力偶。",
            "Draw the couple polygon to the scale $μ_{Wl}$: first the couples that are wholly known. ",
        )
        + TURNED
        + (REVERSED if any(mass.place < here for mass in rotor.masses.values()) else Words("", ""))
        + Words("。", ".")
        + _how(rotor, names),
        place,
    )
    known = [_known(rotor, name, size) for name, size in couples.items() if not rotor.masses[name].unknown]
    tip, letter = _laid(bench, place, known)
    if len(names) == 1:
        return [_solution(rotor, names, ((tip, 0j * tip),), (letter, "O"))]
    met = _corners(bench, rotor, place, names, couples, tip)
    corners = sorted(met, key=lambda corner: _order(rotor, names, {names[0]: corner - tip, names[1]: -corner}))
    marks = ("p",) if len(corners) == 1 else ("p_1", "p_2")
    found = []
    for mark, corner in zip(marks, corners, strict=True):
        corner = board.locate(place, mark, corner)
        board.plot(place, corner, mark)
        ends = ((tip, corner), (corner, 0j * corner))
        for name, (start, stop) in zip(names, ends, strict=True):
            board.arrow(place, start, stop, Role.RESULT, key=couple_of(name).key, label=f"C_{{{name}}}")
        found.append(_solution(rotor, names, ends, (letter, mark, "O")))
    return found


def _how(rotor: Rotor, names: list[str]) -> Words:
    if len(names) == 1:
        return Words(f"封闭边即质量 {names[0]} 的力偶。", f" The closing side is the couple of mass {names[0]}.")
    arcs = [name for name, key in unknowns(rotor.masses) if key == "at"]
    one, other = names
    if len(arcs) == 2:
        return Words(
            f"{one}、{other} 的力偶大小已知而方向未知：自链的两端以其长度为半径作弧，两交点 $p_1$、$p_2$ 给出两个互为"
            "镜像的解。",
            f" Of {one} and {other} the couples are known in size, not in direction: arcs with these radii about the "
            "ends of the chain meet at $p_1$ and $p_2$, two mirrored solutions.",
        )
    if not arcs:
        return Words(
            f"{one}、{other} 的力偶方向已知而大小未知：过链的两端作它们的平行线，交于 $p$。",
            f" Of {one} and {other} the directions are known: parallels to them through the ends of the chain meet "
            "at $p$.",
        )
    return Words(
        f"{one}、{other} 中一个方向已知、一个大小已知：平行线与弧交于 $p_1$、$p_2$，有两个解。",
        f" Of {one} and {other} one is known in direction, the other in size: the parallel meets the arc at $p_1$ and "
        "$p_2$, two answers.",
    )


def _here(rotor: Rotor) -> float:
    """Where the reference plane is along the shaft (m)."""
    return rotor.masses[reference(rotor.masses)].place


def _known(rotor: Rotor, name: str, size: Quantity) -> Laid:
    mass = rotor.masses[name]
    sign = (-1.0 if mass.removed else 1.0) * (1.0 if mass.place > _here(rotor) else -1.0)
    return Laid(named=couple_of(name), size=sign * size.value, degrees=degrees(mass.at.si))


def _laid(bench: Bench, place: Pane, known: list[Laid]) -> tuple[Points, str]:
    if not known:
        bench.board.plot(place, 0j, "O", Dot.POLE)
        return 0j, "O"
    polygon = summed(bench, place, known, None)
    return polygon.tip, polygon.letter


def _solution(
    rotor: Rotor, names: list[str], ends: tuple[tuple[Points, Points], ...], letters: tuple[str, ...]
) -> Solution:
    vectors = {name: stop - start for name, (start, stop) in zip(names, ends, strict=True)}
    between = {name: f"{letters[i]} {letters[i + 1]}" for i, name in enumerate(names)}
    return Solution(vectors=vectors, ends=dict(zip(names, ends, strict=True)), letters=between)


def _order(rotor: Rotor, names: list[str], vectors: Mapping[str, Points]) -> float:
    """Answers are numbered by the first direction that was sought."""
    here = rotor.masses[reference(rotor.masses)].place
    first = next((name for name, key in unknowns(rotor.masses) if key == "at"), names[0])
    sign = 1.0 if rotor.masses[first].place > here else -1.0
    return float(np.degrees(np.angle(nominal(sign * vectors[first])))) % 360.0


def _corners(
    bench: Bench, rotor: Rotor, place: Pane, names: list[str], couples: Mapping[str, Quantity], tip: Points
) -> tuple[Points, ...]:
    """Where the couples of the two masses sought meet: the first from the tip, the second back to the pole."""
    board = bench.board
    lines, radii = _halves(bench, rotor, place, names, couples, tip)
    what = Words("力偶多边形", "the couple polygon")
    try:
        if len(lines) == 2:
            one, other = lines.values()
            corner = board.meet(one, other, what)
            for line in lines.values():
                board.rule(place, line, corner)
            return (corner,)
        if len(radii) == 2:
            pair = board.arcs(tip, radii[names[0]], 0j * tip, radii[names[1]], what)
        else:
            (swung, size), (line,) = next(iter(radii.items())), lines.values()
            pair = board.arc_on_line(line, tip if swung == names[0] else 0j * tip, size, what)
    except DeadPointError:
        at = [degrees(rotor.masses[name].at.si) for name in names]
        raise parallel_couples(at[0], at[1]) from None
    except AssemblyError:
        raise _unclosed(bench, place, tip, radii) from None
    for name, size in radii.items():
        for corner in pair:
            board.swing(place, tip if name == names[0] else 0j * tip, size, corner)
    for line in lines.values():
        for corner in pair:
            board.rule(place, line, corner)
    return pair


def _halves(
    bench: Bench, rotor: Rotor, place: Pane, names: list[str], couples: Mapping[str, Quantity], tip: Points
) -> tuple[dict[str, Line], dict[str, Reals]]:
    """Of the two masses those of known direction as lines, those of known size as radii."""
    board, lines, radii = bench.board, {}, {}
    for name, at in zip(names, (tip, 0j * tip), strict=True):
        if "m" in rotor.masses[name].unknown:
            lines[name] = board.parallel(at, heading(degrees(rotor.masses[name].at.si)), key=couple_of(name).key)
        else:
            radii[name] = board.to_paper(place, couples[name].value)
    return lines, radii


def _unclosed(bench: Bench, place: Pane, tip: Points, radii: Mapping[str, Reals]) -> EquilibriumError:
    mm = bench.board.scale_of(place).value
    sizes = sorted([float(nominal(np.abs(tip))) * mm, *(float(nominal(size)) * mm for size in radii.values())])
    largest, others = sizes[-1], sum(sizes[:-1])
    return no_polygon(largest - others, largest, others)

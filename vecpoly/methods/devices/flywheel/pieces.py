"""The works of the areas of a period: each read, or given, times the scale of areas; their misreading is shared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ....algebra.columns import TOTAL, column, decimals, summed
from ....algebra.quantity import Quantity, magnitude
from ....board.construction import Listing
from ....devices.dynamics.asked import letter, level, work
from ....devices.dynamics.given import Areas
from ....foundation.slotted import replace
from ....plane import Points, Reals, nominal
from ....words import Words
from ...diagrams.indicator import shared_out
from ..bench import Bench
from ..cam.read.readings import noted
from .scales import INDICATOR
from .words import GIVEN, GIVEN_SECTION, shared

NOTHING = 1e-9  # of all works: rounding, and no misreading
HEAD = (
    Words("区间", "from–to"),
    Words("$A$ /mm²", "$A$ /mm²"),
    Words("$W$ /J", "$W$ /J"),
    Words("改正后 $W$ /J", "$W$ corrected /J"),
    Words("段末 $E$ /J", "$E$ at its end /J"),
)


CORRECTED = 3  # column of HEAD


@dataclass(frozen=True, slots=True, kw_only=True)
class Pieces:
    """The works (J, by every hand), the letters at their ends, where these stand on the diagram of moments."""

    works: tuple[Reals, ...]
    letters: tuple[str, ...]
    ends: tuple[Points, ...] = ()


def letters_of(count: int) -> tuple[str, ...]:
    """a, b, c ... and a′ where the period ends."""
    return (*(letter(i) for i in range(count)), "a′")


def given_areas(bench: Bench, load: Areas) -> Pieces:
    """Areas that are known already, times their scale."""
    board, names = bench.board, letters_of(load.count)
    board.section(GIVEN_SECTION)
    board.step(GIVEN)
    scale = magnitude("μ_A", load.scale, "J/mm^2")
    sizes = [magnitude(f"A_{n}", abs(size), "mm^2") for n, size in enumerate(load.sizes, 1)]
    works = works_of(bench, sizes, _signs(bench, load.sizes, names), scale, names)
    return Pieces(works=works, letters=names)


def _signs(bench: Bench, sizes: Sequence[float], names: Sequence[str]) -> list[Reals]:
    """+1 of a surplus, −1 of a deficit: as the first one, and then the other wherever the curves cross."""
    signs: list[Reals] = [1.0 if sizes[0] > 0 else -1.0]
    for n in range(1, len(sizes)):
        crosses = (sizes[n] > 0) is not (sizes[n - 1] > 0)
        signs.append(signs[-1] * bench.board.judged(INDICATOR, names[n], crosses=crosses))
    return signs


def works_of(
    bench: Bench, sizes: Sequence[Quantity], signs: Sequence[Reals], scale: Quantity, names: Sequence[str]
) -> tuple[Reals, ...]:
    """The works as read, what they miss zero by, the works without it, and a table of all that; a deficit's area is
    negative, as its work is."""
    board = bench.board
    signed = [replace(size, value=sign * size.value) for sign, size in zip(signs, sizes, strict=True)]
    read = [size.value * scale.value for size in signed]
    board.write_worked(magnitude("W_1", read[0], "J").node, signed[0] * scale, "J")
    left, works = shared_out(read)
    missed = abs(float(nominal(left))) > NOTHING * sum(abs(float(nominal(one))) for one in read)
    if missed:
        board.remark(shared(float(nominal(left))))
    energy: Reals = 0.0
    rows = []
    for n, (size, raw, value) in enumerate(zip(signed, read, works, strict=True), 1):
        value = board.conclude(f"W_{n}", value, "J")
        energy = energy + value
        noted(bench, work(n), value)
        if n < len(sizes):
            noted(bench, level(n), energy)
        rows.append(_values(size.value, raw, value, energy if n < len(sizes) else 0.0))
    board.tabulate(_table(names, rows, missed))
    return works


def _values(*values: Reals) -> tuple[float, ...]:
    return tuple(float(nominal(value)) for value in values)


def _table(names: Sequence[str], rows: Sequence[tuple[float, ...]], missed: bool) -> Listing:
    """Each column with one count of decimals, and the sum of the works under them."""
    areas, read, works, energies = zip(*rows, strict=True)
    between = [f"{one}–{other}" for one, other in pairwise(names)]
    count = decimals([*read, *works] if missed else read)
    sums, ends = (summed(each, count) for each in (read, works)), [*column(energies, count), ""]
    columns = ([*between, TOTAL], [*column(areas), ""], *sums, ends)
    kept = [n for n in range(len(HEAD)) if missed or n != CORRECTED]
    return Listing(
        head=tuple(HEAD[n] for n in kept), rows=tuple(zip(*(columns[n] for n in kept), strict=True)), blocks=1
    )

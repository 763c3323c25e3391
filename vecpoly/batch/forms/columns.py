"""The columns of the answers form: what is typed from paper, under names that the grader knows."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ...figures import scales as kinds
from ...foundation.roman import CLASS, NUMERALS
from ...grading.equations.row import EquationRow
from ...grading.key import Graded, Kind
from ...names import written_unit
from ...words import bare
from ..register import Register


class What(StrEnum):
    """What a column holds of a quantity."""

    SCALE = "scale"  # the student's own μ
    LENGTH = "mm"
    VALUE = "value"
    PLACE = "place"  # both coordinates, in one cell
    DIRECTION = "deg"
    SENSE = "sense"
    YES_NO = "yes/no"
    CLASS = "class"  # of a mechanism, by its Roman numeral
    TICKS = "ticks"  # of a row of an equation, a sign a term


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """One column: of which problem and quantity, what; its head and unit as they stand in rows 1 and 2; of an
    equation its terms."""

    problem: str
    key: str
    what: What
    unit: str
    terms: int = 0

    @property
    def head(self) -> str:
        """``3-9:v_E``, ``3-9:v_E mm``, ``3-9:omega_3 sense``, ``3-9:mu_v``."""
        whole = f"{self.problem}:{self.key}"
        return f"{whole} {self.what}" if self.what in (What.LENGTH, What.DIRECTION, What.SENSE) else whole


CLASSES = tuple(NUMERALS.values())[1:4]  # Ⅱ Ⅲ Ⅳ: those of Assur groups
IDENTITY = (("学号", "number"), ("姓名", "name"), ("班级", "class"), ("卷号", "sheet"))


def per_mm(mu: str) -> str:
    """The unit in which a scale without one is taken."""
    kind = kinds().get(mu)
    unit = "" if kind is None else written_unit(kind.unit)
    return f"({unit})/mm" if "/" in unit else f"{unit}/mm" if unit else ""


def columns_of(register: Register) -> tuple[Column, ...]:
    """All columns, problem by problem: the rows of its equations, the scales, then what is asked in the order of the
    key."""
    if not register.sheets:
        return ()
    found: list[Column] = []
    for part in register.sheets[0].parts:
        found += [_of_row(part.problem, row) for row in part.key.equations]
        asked = [one for one in part.key.quantities if one.is_counted]
        used = sorted({one.mu for one in asked if one.mu and one.mm})
        found += [Column(problem=part.problem, key=mu, what=What.SCALE, unit=per_mm(mu)) for mu in used]
        for one in asked:
            found += [Column(problem=part.problem, key=one.key, what=what, unit=unit) for what, unit in _parts(one)]
    return tuple(found)


def _of_row(problem: str, row: EquationRow) -> Column:
    return Column(problem=problem, key=row.key, what=What.TICKS, unit=f"{bare(row.printed)}: ✓ ?", terms=len(row.known))


def _parts(one: Graded) -> list[tuple[What, str]]:
    value = (What.VALUE, written_unit(one.unit))
    match one.kind:
        case Kind.PLACE:
            return [(What.PLACE, f"(x, y) {one.written_in}" + (f", {one.origin} = (0, 0)" if one.origin else ""))]
        case Kind.VECTOR:
            return [*([(What.LENGTH, "mm")] if one.mm else []), value, (What.DIRECTION, "°")]
        case Kind.SIGNED:
            return [value, (What.SENSE, "↻ ↺")]
        case Kind.YES_NO:
            return [(What.YES_NO, "✓ ×")]
        case _ if one.key.startswith(CLASS):
            return [(What.CLASS, " ".join(CLASSES))]
        case _:
            return [value]

"""How much squared paper a question has: by what must be worked out, not by what a page happens to leave."""

from __future__ import annotations

from ...algebra.formula import Node, plain
from ...solution import Solution
from .blanks import on_the_way

EACH = 12.0  # mm of squares for a value that is worked out by a formula, at least
ROOMY = 1.5  # times as much at most: 18 mm
LEAST, MOST = 60.0, 200.0  # mm, however little or much is worked out; a whole page has no more
LINE, LISTED = 6, 4  # mm for a line that is worked out, for an equation or a list, where a line each is written
CLOSER = 0.8  # of that, where values are few and their lines many
_PART = 0.5  # of a value: one that a scale alone gives, a vector equation

_SIGNS = ("(", "/", " + ", " − ")  # of more than a product


def working_room(solution: Solution) -> float:
    """How much room the work needs at least, mm: 12 for every value of the results that a formula gives, half of it for
    one that a scale alone gives and for a vector equation; where few values need many lines, about 5 a line; 60 for
    all, and no more than a page. None where nothing is computed but what lengths on paper come to."""
    lines = room_of_lines(solution)
    if not lines:
        return 0.0
    equations = sum(step.equation is not None for step in solution.construction.steps)
    values = len(on_the_way(solution)) + sum(map(weight, _results(solution))) + _PART * equations
    return min(max(EACH * values, CLOSER * lines, LEAST), MOST)


def _results(solution: Solution) -> list[Node]:
    """The lines that give what is asked, each once."""
    formulas = (one.reading.formula for one in solution.answers.values())
    return [*{plain(one): one for one in formulas if one is not None}.values()]


def weight(formula: Node) -> float:
    """What part of a value's room a formula needs: all for v_B = ω_1 l_AB = 2 × 30 = 60 mm/s; half for v_C = μ_v pc =
    2 × 41 = 82 mm/s, which a scale alone gives; none for φ = 140°, which is read."""
    parts = plain(formula).split(" = ")
    if len(parts) < 3:
        return 0.0
    scaled = parts[1].startswith("μ") and not any(sign in parts[1] for sign in _SIGNS)
    return _PART if scaled else 1.0


def room_of_lines(solution: Solution) -> float:
    """The room in which every line that is worked out is written, and what the steps list, mm. None where nothing is
    computed but what lengths on paper come to, for which the table has room."""
    steps = solution.construction.steps
    lines = sum(not _only_read(plain(line)) for step in steps for line in step.formulas)
    listed = sum(bool(step.equation or step.listing) for step in steps)
    return float(LINE * lines + LISTED * listed)


def _only_read(line: str) -> bool:
    """Whether a line is a reading, or one times its scale: φ = 140°, l_AB = μ_l AB = 0.001 × 44.7 = 44.7 mm."""
    return line.count(" = ") < 2 or (" = μ" in line and "(" not in line and "/" not in line)

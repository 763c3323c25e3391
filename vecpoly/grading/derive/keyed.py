"""The key of a problem, from the acts of its construction."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from ...answer import YES_NO, Answer, bearing
from ...board.acts import Act, Area, Compute, Locate, Measure
from ...board.acts import Answer as Wrote
from ...board.hand import Hand
from ...board.otherwise.amended import AS_DRAWN, plain_letters
from ...board.place import View, views
from ...errors import VecpolyError
from ...figures import View as Figured
from ...foundation.indices import ON_LINE
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...methods.drawn import Drawn
from ...names import Named, parse_rel
from ...problem.asked.checks import is_check
from ...problem.problem import Problem
from ...solution import Solution, constructed, scales_of, solve, solve_by_hands
from ...words import Words
from ..allowance import STUDENT, Allowance
from ..equations.priced import priced
from ..equations.row import rows_of
from ..key import AnswerKey, Graded, Kind, spot_letters
from .blocks import DIAGRAM, block_of
from .needs import needs, with_lines
from .rubric import USUAL, Rubric, shared
from .tolerance import Scatter, with_tolerance

TURNING = ("rad/s", "rad/s^2")
LEFT_OUT = ("", "deg")  # computed on the way, and no step that one ticks
ZERO = 1e-9


def answer_key(problem: Problem, allowance: Allowance = STUDENT, rubric: Rubric = USUAL) -> AnswerKey:
    """What is graded of a problem: all that is asked, and every length and value found on the way.

    T = clip(k √(Σ(∂y/∂e σ)² + σ_read²), floor, cap), the root as the scatter of 300 students' hands that draw the whole
    construction. Raises what `solve` raises, and VecpolyError where an answer is suspect or no linkage serves: there is
    nothing to grade by.
    """
    solution, drawn = _solved(problem, allowance.hand())
    said = {"suspect": solution.construction.warning, "no-solution": solution.construction.conclusion}
    for code, why in said.items():
        if why is not None:
            raise VecpolyError(Words("不能据此批改：", "no key to grade by: ") + why, code=code)
    found = _Found(solution, drawn)
    steps = found.steps()
    known = {act.number: one.key for act, one in steps} | found.on_the_way({one.key for _, one in steps})
    scales = scales_of(drawn.construction).given
    scatter = Scatter(drawn, allowance, scales)
    once: dict[str, tuple[Act, Graded]] = {}
    first = {key: number for number, key in sorted(known.items(), reverse=True)}
    for act, one in sorted(steps, key=lambda step: first[step[1].key]):
        once.setdefault(one.key, (act, one))  # a length that is read again is the same length
    graded = [
        with_tolerance(replace(one, needs=needs(drawn.construction.acts, act, known, one.key)), act, scatter)
        for act, one in once.values()
    ]
    graded = with_lines(graded)
    quantities, stated = shared(rubric, scatter.bounded(graded), scales)
    return AnswerKey(
        problem=problem.id, quantities=quantities, scales=dict(scales), stated=stated, allowance=allowance,
        equations=priced(rows_of(solution.construction), quantities, rubric.equations),
        solutions=_numbers(solution),
    )  # fmt: skip


def _solved(problem: Problem, by: Hand) -> tuple[Solution, Drawn]:
    """The solution by an exact hand, and what the hands beside it found."""
    if isinstance(problem.subject, Mechanism):
        return solve_by_hands(problem, by)
    return solve(problem, by="exact", repeats=0, precise=False), constructed(problem, by, AS_DRAWN)


def _numbers(solution: Solution) -> tuple[int, ...]:
    """The numbers of the candidates that are asked for by their numbers, and of the one that is asked for beside them
    without (AB, AB_2)."""
    numbers = [one.number for one in solution.construction.candidates]
    asked = {n: [key.removesuffix(f"_{n}") for key in solution.answers if key.endswith(f"_{n}")] for n in numbers}
    beside = any(name in solution.answers for names in asked.values() for name in names)
    taken = getattr(solution.problem.subject, "take", 0) if beside else 0
    return tuple(n for n in numbers if asked[n] or n == taken)


@dataclass(frozen=True, slots=True)
class _Found:
    """A solution with the acts of its construction."""

    solution: Solution
    drawn: Drawn

    def steps(self) -> list[tuple[Act, Graded]]:
        """Each graded quantity with the act that gave it, in the order of the sheet."""
        acts = self.drawn.construction.acts
        asked = {act.key: act for act in acts if isinstance(act, Wrote) and act.key in self.solution.answers}
        places = {key for key, one in self.solution.answers.items() if one.is_place}
        named = [act for act in acts if isinstance(act, Measure) and act.key]  # lifts between stations have no letters
        read = [act for act in named if act.mm > ZERO and not _of_place(act, places)]
        worked = [act for act in acts if isinstance(act, Compute) and act.key not in asked and _is_step(act)]
        computed = {act.key: act for act in reversed(worked)}  # what is worked once more, as a check, leads nowhere
        taken = {*asked, *computed}
        steps: list[tuple[Act, Graded]] = [(act, _reading(act, _name(act, named, taken))) for act in read]
        steps += [(act, _area(act)) for act in acts if isinstance(act, Area) and act.mm2 > ZERO]
        steps += [(act, _computed(act)) for act in computed.values()]
        steps += [(act, self._asked(self.solution.answers[key])) for key, act in asked.items()]
        return sorted(steps, key=lambda step: step[0].number)

    def on_the_way(self, keys: set[str]) -> dict[int, str]:
        """Number → key of the acts that compute what is asked, by its key or, as θ is theta, by its symbol:
        what follows rests on these, and not on the answer written down.
        """
        acts = self.drawn.construction.acts
        written = ((act.key, acts[number]) for act in acts if isinstance(act, Wrote) for number in act.inputs)
        behind = {one.number: key for key, one in written if key in keys and self._computes(one, key)}
        spots = {spot_letters(key): key for key, one in self.solution.answers.items() if one.is_place and key in keys}
        named = {act.number: spots[act.key] for act in acts if isinstance(act, Locate) and act.key in spots}
        return behind | named | {act.number: act.key for act in acts if isinstance(act, Compute) and act.key in keys}

    def _computes(self, act: Act, key: str) -> bool:
        found = self.solution.answers.get(key)
        return isinstance(act, Compute) and found is not None and act.key == plain_letters(found.reading.symbol)

    def _asked(self, answer: Answer) -> Graded:
        kind, unit = _kind(answer), answer.reading.unit
        scale = next((v.mu.key for v in views() if v.mu.symbol == answer.reading.scale and v.mu.unit == unit), "")
        mu = scales_of(self.drawn.construction).given.get(scale)
        place = answer.exact_vector if kind is Kind.PLACE else None
        vector = answer.exact_vector if kind is Kind.VECTOR and abs(answer.exact) > ZERO else None
        return Graded(
            key=answer.key,
            symbol=answer.reading.symbol,
            kind=kind,
            unit=unit,
            block=DIAGRAM if kind is Kind.LINE else block_of(None, unit),
            exact=answer.exact,
            asked=not is_check(answer.key, self.solution.answers),
            mu=scale,
            mm=abs(answer.exact) / mu if mu and kind is Kind.VECTOR else None,
            degrees=bearing(vector) if vector is not None else None,
            at=(place.real, place.imag) if place is not None else None,
            origin=_origin(self.solution.problem) if kind is Kind.PLACE else "",
            unsigned=isinstance(answer.rel, Named) and answer.rel.is_size,
        )


def _origin(problem: Problem) -> str:
    """The fixed point in which the axes begin; nothing where the problem begins them elsewhere."""
    frame = problem.subject.frame if isinstance(problem.subject, Mechanism) else {}
    return next((letter for letter, at in frame.items() if abs(at) <= ZERO), "")


def _kind(answer: Answer) -> Kind:
    """How an answer is compared."""
    if answer.is_place:
        return Kind.LINE if answer.exact_vector is None else Kind.PLACE
    if answer.reading.unit == YES_NO:
        return Kind.YES_NO
    if answer.exact_vector is not None:
        return Kind.VECTOR
    return Kind.SIGNED if answer.turns else Kind.SCALAR


def _computed(act: Compute) -> Graded:
    kind = Kind.SIGNED if act.unit in TURNING else Kind.SCALAR
    return Graded(
        key=act.key, symbol=_symbol(act.key), kind=kind, unit=act.unit, block=block_of(None, act.unit), exact=act.value
    )


def _area(act: Area) -> Graded:
    """An area that was counted: a value by itself, for no ruler tells it."""
    return Graded(
        key=act.key, symbol=_lettered(act.key), kind=Kind.SCALAR, unit="mm^2", block=block_of(_view(act)), exact=act.mm2
    )


def _symbol(key: str) -> str:
    """The textbook's symbol of a quantity on the way."""
    try:
        return parse_rel(key).symbol
    except VecpolyError:
        head, _, body = key.partition("_")
        return f"{head}_{{{body}}}" if body else head


def _is_step(act: Compute) -> bool:
    return bool(act.key) and act.key.translate(ON_LINE).isascii() and act.unit not in LEFT_OUT


def _of_place(act: Measure, places: set[str]) -> bool:
    """Whether this is how coordinates are read, and no length of the drawing."""
    return any(spot_letters(key) == act.key for key in places)


def _reading(act: Measure, name: str) -> Graded:
    view = _view(act)
    return Graded(
        key=name,
        symbol=_lettered(act.key),
        kind=Kind.READING,
        unit="mm",
        block=block_of(view),
        exact=act.mm,
        mm=act.mm,
        degrees=bearing(act.b - act.a),
        mu=view.mu.key if view else "",
    )


def _lettered(letters: str) -> str:
    """The letters of a length as they are printed: n2'c2' → n_{2}^′c_{2}^′."""
    return re.sub(r"([A-Za-z])(\d*)('?)", _letter, letters)


def _letter(found: re.Match[str]) -> str:
    return found[1] + (f"_{{{found[2]}}}" if found[2] else "") + ("^′" if found[3] else "")


def _name(act: Measure, named: Sequence[Measure], taken: set[str]) -> str:
    """The letters of a length, with its figure where two lengths have them, be one of them nothing; with mm where a
    quantity has them.
    """
    alone = all(abs(one.mm - act.mm) <= ZERO * act.mm for one in named if _ends(one) == _ends(act))
    name = act.key if alone else act.names[0]
    return f"{name} mm" if name in taken else name


def _ends(act: Measure) -> list[str]:
    """The letters of a length, which has them either way: cb is bc."""
    return sorted(_LETTERS.findall(act.key))


_LETTERS = re.compile(r"[A-Za-z]\d*'*")


def _view(act: Act) -> Figured | None:
    place = act.head.place
    return None if place is None else place if isinstance(place, View) else place.view

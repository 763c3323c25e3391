"""How a class is marked: the rules, points by part of a solution, and points of single quantities by problem."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ..errors import FaultError
from ..foundation.slotted import replace
from ..problem.marking import Marking
from ..problem.schema.faults import Faults, meant
from ..problem.schema.marking import BlockSpec, MarkingSpec, PointsSpec
from ..words import Words
from .derive.rubric import USUAL, Block, Rubric, shared
from .equations.priced import priced
from .key import AnswerKey, Points
from .rules import USUAL_RULES, Rules

SAME = 1e-6  # of points: nearer to each other two totals are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Scheme:
    """rules: shares and guards. blocks: points of parts that are not shared out as usual, by their names.

    points: of single quantities, by problem; they stand instead of what the parts give them.
    """

    rules: Rules = USUAL_RULES
    blocks: Mapping[str, Block] = field(default_factory=dict)
    points: Mapping[str, Mapping[str, Points]] = field(default_factory=dict)

    def key(self, key: AnswerKey) -> AnswerKey:
        """A key with the points of this scheme, whatever points it had."""
        rubric = Rubric(blocks={**USUAL.blocks, **self.blocks}, own=self.points.get(key.problem, {}))
        quantities, stated = shared(rubric, key.quantities, key.scales)
        equations = priced(key.equations, quantities, rubric.equations)
        return replace(key, quantities=quantities, stated=stated, equations=equations)

    def over(self, said: MarkingSpec) -> Scheme:
        """This scheme, changed in what is said."""
        rules = {name: value for name, value in said.rules.model_dump().items() if value is not None}
        blocks = {name: _block(spec) for name in type(said.rubric).model_fields if (spec := getattr(said.rubric, name))}
        points = {
            problem: {**self.points.get(problem, {}), **{key: _points(one) for key, one in each.items()}}
            for problem, each in said.points.items()
        }
        return Scheme(
            rules=replace(self.rules, **rules), blocks={**self.blocks, **blocks}, points={**self.points, **points}
        )


USUAL_SCHEME = Scheme()


def _block(spec: BlockSpec) -> Block:
    return Block(**spec.model_dump())


def _points(spec: PointsSpec) -> Points:
    return Points(**spec.model_dump())


def scheme_of(marking: Marking, keys: Mapping[str, AnswerKey], base: Scheme = USUAL_SCHEME) -> Scheme:
    """The scheme that is said, over another.

    keys: of each problem, the key of one of its variants. Raises ProblemFileError, with every line, where points stand
    for a problem or a quantity that there is not, where a rule names such a quantity, or where totals do not come out.
    """
    scheme, faults = base.over(marking.said), marking.faults
    for problem, each in marking.said.points.items():
        with faults.at("points", problem):
            if problem not in keys:
                raise _no_problem(problem, keys)
        for name in each if problem in keys else ():
            with faults.at("points", problem, name):
                _known(name, (keys[problem],))
    for rule in ("independent", "first"):
        for at, name in enumerate(getattr(marking.said.rules, rule) or ()):
            with faults.at("rules", rule, at):
                _known(name, keys.values())
    faults.settle()
    _add_up(marking, scheme, keys, faults)
    return scheme


def _known(name: str, keys: Iterable[AnswerKey]) -> None:
    """Raise where none of the keys has this quantity."""
    there = [one.key for key in keys for one in key.quantities]
    if name not in there:
        raise FaultError(
            Words(f"没有可评分的量“{name}”", f"no quantity '{name}' is graded") + meant(name, there),
            code="unknown-name",
        )


def _no_problem(name: str, keys: Iterable[str]) -> FaultError:
    said = Words(f"作业中没有题“{name}”", f"the assignment has no problem '{name}'")
    return FaultError(said + meant(name, keys), code="unknown-name")


def _add_up(marking: Marking, scheme: Scheme, keys: Mapping[str, AnswerKey], faults: Faults) -> None:
    """Raise where the points of a problem come to something else than is printed."""
    for problem, total in marking.said.totals.items():
        with faults.at("totals", problem):
            if problem not in keys:
                raise _no_problem(problem, keys)
            worth = scheme.key(keys[problem]).worth
            if abs(worth - total) > SAME:
                raise FaultError(
                    Words(
                        f"题 {problem} 各项分值之和为 {worth:g}，而 totals 写的是 {total:g}；请改正其一",
                        f"the points of {problem} come to {worth:g}, totals says {total:g}; mend one",
                    ),
                    code="totals",
                    numbers={"points": worth, "total": total},
                )
    faults.settle()

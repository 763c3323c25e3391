"""How a class is marked: the rules, points by part of a solution, and points of single quantities by problem."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from ..errors import FaultError, UnknownNameError
from ..foundation.slotted import replace
from ..problem.marking import Marking
from ..problem.schema.faults import Faults, meant
from ..problem.schema.marking import BlockSpec, MarkingSpec, PointsSpec
from ..words import Words
from .derive.rubric import USUAL, Block, Rubric, shared
from .equations.priced import priced
from .key import AnswerKey, Graded, Kind, Points
from .reading.symbol import keyed
from .rules import USUAL_RULES, Rules

Names = tuple[str, ...] | None
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
    for a problem or a quantity that there is not, or for a sense that it has not, where a rule names such a quantity,
    or where totals do not come out.
    """
    said, faults = marking.said, marking.faults
    points: dict[str, dict[str, PointsSpec]] = {}
    for problem, each in said.points.items():
        with faults.at("points", problem):
            if problem not in keys:
                raise _no_problem(problem, keys)
        points[problem] = _worths(problem, each, keys[problem], faults) if problem in keys else {}
    rules = {rule: _names(rule, getattr(said.rules, rule), keys, faults) for rule in ("independent", "first")}
    faults.settle()
    scheme = base.over(said.model_copy(update={"points": points, "rules": said.rules.model_copy(update=rules)}))
    _add_up(marking, scheme, keys, faults)
    return scheme


def _worths(problem: str, said: Mapping[str, PointsSpec], key: AnswerKey, faults: Faults) -> dict[str, PointsSpec]:
    """The points of single quantities of a problem, by the keys that their names mean."""
    found: dict[str, PointsSpec] = {}
    for name, points in said.items():
        with faults.at("points", problem, name):
            known = _meant(name, [one.key for one in key.quantities])
            if known in found:
                raise FaultError(
                    Words(f"“{name}”即 {known}，分值写了两次", f"'{name}' is {known}, whose points are said twice"),
                    code="said-twice",
                )
            _earned(points, key[known])
            found[known] = points
    return found


def _names(rule: str, names: Sequence[str] | None, keys: Mapping[str, AnswerKey], faults: Faults) -> Names:
    """The keys that the names in a rule mean."""
    there, found = [one.key for key in keys.values() for one in key.quantities], list[str]()
    for at, name in enumerate(names or ()):
        with faults.at("rules", rule, at):
            found.append(_meant(name, dict.fromkeys(there)))
    return None if names is None else tuple(found)


def _meant(name: str, there: Iterable[str]) -> str:
    """The key of a name as people write it: ω_3, v_E, w3. Raises FaultError where there is none, or more than one."""
    known = tuple(there)
    try:
        return keyed(name, known)
    except UnknownNameError as unknown:
        if unknown.code == "ambiguous-symbol":
            raise
        said = Words(f"没有可评分的量“{name}”", f"no quantity '{name}' is graded")
        raise FaultError(said + meant(name, known), code="unknown-name") from None


def _earned(points: PointsSpec, one: Graded) -> None:
    """Raise where nobody could have them: for the sense of what has none."""
    if points.sense and one.kind not in (Kind.SIGNED, Kind.VECTOR):
        raise FaultError(
            Words(
                f"“{one.key}”没有转向或指向，{points.sense:g} 分（sense）谁也得不到；请分给 method 或 accuracy",
                f"'{one.key}' has no sense, so that nobody could have its {points.sense:g} points; "
                "give them to method or accuracy",
            ),
            code="no-sense",
            numbers={"points": points.sense},
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

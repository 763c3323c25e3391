"""One part of a project file as a problem, and solved: what it takes from earlier parts put in."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ..cycle import cycle
from ..errors import FaultError
from ..found import taken as solution_taken
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from ..problem.assignment import part as branch
from ..problem.build import build
from ..problem.load import reaching
from ..problem.problem import Problem
from ..problem.schema.faults import Faults, meant
from ..problem.schema.validate import validate
from ..problem.text.overlay import overlay
from ..problem.text.source import Tree
from ..solution import Solution, solve
from ..units.reading import Dim, positive, read
from ..units.reckoning import Amount, reckon
from ..words import Words
from .measured import known
from .part import FINE, Part
from .positions import Position, position, refuse_idle
from .spec import OWN, PartSpec
from .substitute import substituted
from .working import Working, Works, working


def made(
    tree: Tree, key: str, project: str, before: tuple[Part, ...], *, by: str, seed: int,
    tell: Callable[[Words], None] | None = None,
) -> Part:  # fmt: skip
    """The part under this key, solved. Raises ProblemFileError with its faults, and what `solve` raises."""
    faults = Faults(tree.name, tree.places)
    data = substituted(tree.data["parts"][key], known(before, exact=False), faults, "parts", key)
    faults.settle()
    spec = validate(PartSpec, {name: data.pop(name) for name in OWN if name in data}, faults, "parts", key)
    own = branch(tree, ("parts", key))
    own.data = {"id": f"{project}-{key}", **data}
    base, taken = _base(spec, before, faults, key)
    problem = _problem(own, base, taken)
    also, works, delta = _beside(spec, problem, faults, key)
    acting: Working | None = None
    if problem.loads is not None:
        turn = None
        with faults.at("parts", key):
            turn = cycle(problem, FINE)
        faults.settle()
        assert turn is not None
        with faults.at("parts", key, "works"):
            acting = working(turn, works)
            refuse_idle(problem, acting)
    faults.settle()
    if tell is not None:
        tell(problem.title)
    solution: Solution | None = None
    with faults.at("parts", key):
        solution = solve(problem, by=by, seed=seed)
        _refuse_unsolved(solution)
    faults.settle()
    assert solution is not None
    found = Part(name=key, solution=solution, base=base, taken=taken, works=works, acting=acting, unevenness=delta)
    others = _others(found, also, faults, by, seed)
    return replace(found, others=others, acting=found.working) if others else found


def _refuse_unsolved(solution: Solution) -> None:
    """Raise FaultError where no candidate serves: what comes after has no lengths to go on with."""
    if (why := solution.construction.conclusion) is not None:
        raise FaultError(why.plain, code="no-solution")


def _others(found: Part, also: tuple[float, ...], faults: Faults, by: str, seed: int) -> tuple[Position, ...]:
    """The drawings at the further positions."""
    made = []
    for i, phi in enumerate(also):
        with faults.at("parts", found.name, "also", i):
            made.append(position(found.solution, phi, found.working, by, seed))
    faults.settle()
    return tuple(made)


def _base(
    spec: PartSpec, before: tuple[Part, ...], faults: Faults, key: str
) -> tuple[Part | None, Mapping[str, float]]:
    """The part whose linkage is taken, and its lengths (mm), rounded as asked."""
    if spec.of is None:
        return None, {}
    found: Part | None = None
    taken: dict[str, float] = {}
    with faults.at("parts", key, "of"):
        found = _earlier(spec.of, before)
        step = positive(spec.round).si * 1e3 if spec.round is not None else 0.0
        taken = _rounded(found, step)
    faults.settle()
    return found, taken


def _earlier(name: str, before: tuple[Part, ...]) -> Part:
    finding = [one for one in before if one.finds]
    found = next((one for one in finding if one.name == name), None)
    if found is None:
        raise FaultError(
            Words(f"前面没有名为“{name}”的机构综合部分", f"no earlier part called '{name}' finds a linkage")
            + meant(name, [one.name for one in finding]),
            code="unknown-name",
        )
    return found


def _rounded(found: Part, step: float) -> dict[str, float]:
    """The values of the solution that is taken, as read; lengths to whole steps (mm)."""
    design, one = found.problem.design, solution_taken(found.problem, found.solution.construction.candidates)
    if one is None or design.built(one.values) is None:
        raise FaultError(
            Words(f"“{found.name}”没有求出可用的机构", f"'{found.name}' found no linkage that could be taken"),
            code="no-solution",
        )
    return {
        key: round(value / step) * step if step and design.is_length(key) else value
        for key, value in one.values.items()
    }


def _problem(own: Tree, base: Part | None, taken: Mapping[str, float]) -> Problem:
    if base is None:
        return build(reaching(own, (), own.reach))
    built = base.problem.design.built(taken)
    assert built is not None
    return replace(build(overlay(Tree("", built, reach=own.reach), own)), path=None)


def _beside(
    spec: PartSpec, problem: Problem, faults: Faults, key: str
) -> tuple[tuple[float, ...], Works | None, float | None]:
    """Further positions, the load of one stroke, [δ]: of a mechanism only."""
    if not isinstance(problem.subject, Mechanism):
        for name in ("also", "works", "unevenness"):
            if getattr(spec, name):
                with faults.at("parts", key, name):
                    raise FaultError(
                        Words(f"“{name}”只用于机构；请删去", f"'{name}' is for mechanisms only; leave it out"),
                        code="contradiction",
                    )
        faults.settle()
        return (), None, None
    dim = Dim.LENGTH if problem.mechanism.drive.slide else Dim.ANGLE
    also: list[float] = []
    for i, text in enumerate(spec.also):
        with faults.at("parts", key, "also", i):
            also.append(read(text, dim).si + problem.mechanism.drive.lead)
    works, delta = None, None
    with faults.at("parts", key, "works"):
        works = _works(spec)
    with faults.at("parts", key, "unevenness"):
        delta = None if spec.unevenness is None else _pure(spec.unevenness, 0.5)
    faults.settle()
    return tuple(also), works, delta


def _works(spec: PartSpec) -> Works | None:
    if spec.works is None:
        return None
    begins, ends = (_pure(text, 1.0, 0.0) for text in (spec.works.begins, spec.works.ends))
    if begins >= ends:
        raise FaultError(
            Words(
                f"from {begins:.0%} 应小于 to {ends:.0%}；如写 from: 5 %, to: 95 %",
                f"from {begins:.0%} must be less than to {ends:.0%}; write e.g. from: 5 %, to: 95 %",
            ),
            code="contradiction",
        )
    return Works(load=spec.works.load, begins=begins, ends=ends)


def _pure(text: Any, most: float, least: float = 1e-6) -> float:
    """A pure number within bounds: 5 %, 1/40."""
    value = reckon(str(text), {})
    if value != Amount(value.si) or not least <= value.si <= most:
        raise FaultError(
            Words(
                f"“{text}”应为 {least:g} 至 {most:g} 之间的数，如 5 %",
                f"'{text}' must be a number between {least:g} and {most:g}, e.g. 5 %",
            ),
            code="out-of-range",
        )
    return value.si

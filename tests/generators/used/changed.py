"""One's own readings, points and values: as they were they change nothing, to the bit; else there is another solution,
or a refusal, and what `vary` writes is the problem that it made."""

from __future__ import annotations

import numpy as np

from vecpoly import loads
from vecpoly.board.acts import Act, Area, Locate, Measure
from vecpoly.errors import VecpolyError
from vecpoly.grading.student import check_answers
from vecpoly.mistakes import slips
from vecpoly.problem.values.vary import parameters, vary
from vecpoly.solution import Solution

from ..family import family
from .anything import anything, solved, unlike, used

FEW = 4


def _some(rng: np.random.Generator, acts: list[Act]) -> list[Act]:
    return [acts[n] for n in sorted(rng.permutation(len(acts))[:FEW])]


def _named(act: Act) -> str:
    return f"{act.figure}:{act.key}" if act.figure else act.key


def _lettered(solution: Solution, *kinds: type) -> list[Act]:
    """The readings, or the points, that can be named: "—" stands for one that has no letters, and the tips of normal
    accelerations of a link that has several may be called alike."""
    known = [act for act in solution.construction.acts if isinstance(act, kinds) and act.key.strip("—")]
    places = {_named(act): {_value(one) for one in known if _named(one) == _named(act)} for act in known}
    return [act for act in known if len(places[_named(act)]) == 1]


def _value(act: Act) -> complex:
    """What was read or found."""
    if isinstance(act, Locate):
        return act.at
    read: float = getattr(act, "mm", 0.0) or getattr(act, "mm2", 0.0)
    return complex(read)


@used
def own_reading(solution: Solution, rng: np.random.Generator) -> str:
    """With the reading that was read, and with the point that was found, all is as it was."""
    for act in _some(rng, _lettered(solution, Measure, Area)):
        size = act.mm if isinstance(act, Measure) else act.mm2 if isinstance(act, Area) else 0.0
        again = solved(solution.problem, readings={_named(act): size})
        if wrong := unlike(solution, again):
            return f"{_named(act)} read as {size}: {wrong}"
    for act in _some(rng, _lettered(solution, Locate)):
        assert isinstance(act, Locate)
        again = solved(solution.problem, points={_named(act): act.at})
        if wrong := unlike(solution, again):
            return f"{_named(act)} found at {act.at}: {wrong}"
    return ""


@used
def misread(solution: Solution, rng: np.random.Generator) -> str:
    """A reading that is quite wrong, and a mistake, lead to a solution or to a refusal."""
    for act in _some(rng, _lettered(solution, Measure)):
        assert isinstance(act, Measure)
        for size in (1.03 * act.mm + 0.2, 0.0, 1e4):
            _tried(solution, readings={_named(act): size})
    known = slips(solution.problem)
    for n in sorted(rng.permutation(len(known))[:FEW]):
        _tried(solution, slip=known[n])
    return ""


def _tried(solution: Solution, **otherwise: object) -> None:
    try:
        str(solved(solution.problem, **otherwise))  # type: ignore[arg-type]
    except VecpolyError as error:
        assert error.words.zh and error.words.en


@used
def varied(solution: Solution, rng: np.random.Generator) -> str:
    """A value as it is written changes nothing; another makes the problem that its text says."""
    problem, known = solution.problem, parameters(solution.problem)
    for name in rng.permutation(sorted(known))[:FEW]:
        same = vary(problem, {str(name): known[name]})
        if same.text != problem.text:
            return f"{name}: {known[name]} changes the text"
        if wrong := unlike(solution, solved(same)):
            return f"{name}: {known[name]}: {wrong}"
        try:
            other = vary(problem, {str(name): known[name].replace("1", "2").replace("5", "6")})
            drawn = solved(other)
        except VecpolyError:
            continue
        if wrong := unlike(drawn, solved(loads(other.text))):
            return f"{name} varied, and its text: {wrong}"
    return ""


@used
def graded(solution: Solution, rng: np.random.Generator) -> str:
    """The exact values as somebody's answers are right."""
    given = {
        key: float(one.exact)
        for key, one in solution.answers.items()
        if not one.undefined and one.exact_vector is None and one.reading.unit
    }
    checked = check_answers(solution.problem, given) if given else None
    return "" if checked is None or checked.right else f"the exact values are not right: {checked}"


family("used-readings", also=own_reading, often=1, first=1)(anything("readings"))
family("used-misread", also=misread, often=1, first=4)(anything("misread"))
family("used-varied", also=varied, often=1, first=1)(anything("varied"))
family("used-graded", also=graded, often=1, first=5)(anything("graded"))

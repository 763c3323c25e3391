"""Other problems in place of the library, for all claims that name it."""

from __future__ import annotations

import inspect
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import wraps
from typing import Any

import pytest

import tests.drawn_library as drawn_library
import tests.each as each
import vecpoly.door as door
import vecpoly.problem.load as loading
from vecpoly import loads

SHOWN = 300  # letters of what is told of one that fails


@dataclass(frozen=True, slots=True)
class Tried:
    """How often each claim was made, and what it said of those of which it does not hold."""

    made: Counter[str] = field(default_factory=Counter)
    failed: dict[tuple[str, str], str] = field(default_factory=dict)

    def __str__(self) -> str:
        of = Counter(claim for claim, _ in self.failed)
        lines = [f"{count:4d} of {self.made[claim]:4d}  {claim}" for claim, count in of.most_common()]
        told = [f"{claim}\n    {case}: {what}" for (claim, case), what in sorted(self.failed.items())]
        whole = f"{len(self.failed)} of {self.made.total()} claims about a member do not hold"
        return "\n".join([*told, "", *lines, whole])


def in_place_of_the_library(members: Mapping[str, str], files: Sequence[str]) -> Tried:
    """Every claim that is made of each problem of the library, made of these members instead."""
    tried = Tried()

    def in_place_of(load: Callable[..., Any]) -> Callable[..., Any]:
        return lambda name, *args, **more: loads(members[name]) if name in members else load(name, *args, **more)

    def of_members(cases: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
        return lambda claim: _of_all(claim, cases, members, tried)

    names = tuple(members)
    for room, name, value in (
        *((room, "load", in_place_of(vars(room)["load"])) for room in (loading, door, drawn_library)),
        *((drawn_library, name, names) for name in ("LIBRARY", "IDS")),
        (each, "each", of_members),
    ):
        setattr(room, name, value)
    # of what is refused when it is drawn as on paper no sheet is claimed
    drawn_library.DRAFTED = tuple(name for name in names if drawn_library.drafted(name) is not None)
    pytest.main(["-q", "-n0", "-p", "no:cacheprovider", "--noconftest", "--tb=no", "-rN", *files], plugins=[_Only()])
    return tried


def _of_all(
    claim: Callable[..., None], cases: Iterable[Any], members: Mapping[str, str], tried: Tried
) -> Callable[..., None]:
    """The claim about those of the cases that are members."""
    named = f"{claim.__module__.removeprefix('tests.')}.{claim.__name__}"

    @wraps(claim)
    def of_all(*args: Any, **given: Any) -> None:
        for case in cases:
            if not isinstance(case, str) or case not in members:
                continue
            tried.made[named] += 1
            if (failure := each._failure(claim, case, *args, **given)) is not None:
                said = str(failure).split("\nassert ")[0] or repr(failure)
                tried.failed[named, case] = f"{type(failure).__name__}: {' '.join(said.split())[:SHOWN]}"

    _, *fixtures = inspect.signature(claim).parameters.values()
    of_all.__signature__ = inspect.Signature(fixtures)  # type: ignore[attr-defined]
    of_all.__dict__["by_lot"] = True
    return of_all


class _Only:
    """Of all tests those that are about each problem."""

    def pytest_collection_modifyitems(self, items: list[Any]) -> None:
        """Leave the others away."""
        items[:] = [one for one in items if one.function.__dict__.get("by_lot")]

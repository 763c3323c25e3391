"""Families of random problems: a function registered by `family` writes the text of one;
adding the file adds the family."""

from __future__ import annotations

import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module

import numpy as np

from vecpoly.solution import Solution

Make = Callable[[np.random.Generator], str]


@dataclass(frozen=True, slots=True)
class OnText:
    """A check of a text of which no solution is drawn: an assignment, a motion that has exact answers only."""

    wrong: Callable[[str], str]


Check = Callable[[Solution], str] | OnText  # what is wrong with a solution, or "" where nothing is


def content(solution: Solution) -> str:
    """The check of a family that needs none of its own."""
    return ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Family:
    """One kind of problem: its name, what writes a random member, a further check of the solution (a third party's).

    often: members that are judged in every run of the tests, fewer where one takes long, from `first` on, which is
    where the members that come before take long, or are refused; `make soak` judges hundreds.
    """

    name: str
    make: Make
    also: Check
    often: int
    first: int

    @property
    def tried(self) -> range:
        """The numbers of the members that are judged in every run of the tests."""
        return range(self.first, self.first + self.often)


_FAMILIES: dict[str, Family] = {}


def family(name: str, also: Check = content, often: int = 2, first: int = 0) -> Callable[[Make], Make]:
    """Register a function as the maker of a family's members."""

    def register(make: Make) -> Make:
        if name in _FAMILIES:
            raise ValueError(f"two functions make the family {name}")
        _FAMILIES[name] = Family(name=name, make=make, also=also, often=often, first=first)
        return make

    return register


def member(one: Family, seed: int, number: int) -> str:
    """The member of a family with this number: the same for the same seed, in any order."""
    return one.make(np.random.default_rng([seed, number]))


@cache
def families() -> tuple[Family, ...]:
    """All registered families, by name."""
    here = import_module(__package__)
    for module in pkgutil.iter_modules(here.__path__):
        if module.name != "__main__":
            import_module(f"{__package__}.{module.name}")
    return tuple(sorted(_FAMILIES.values(), key=lambda one: one.name))

"""A task as text, and what was found of its valid solutions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from vecpoly.board.candidates import Candidate
from vecpoly.solution import Solution

CLOSE = 1e-7  # of a length, or a radian


def task(kind: str, data: Mapping[str, str], find: str, door: str = "synthesis") -> str:
    """The problem file."""
    body = "\n".join(f"  {key}: {value}" for key, value in data.items())
    return f"id: t\ntitle: t\n{door}: {kind}\ndata:\n{body}\nfind: [{find}]\n"


def valid(solution: Solution) -> Iterator[Candidate]:
    """The solutions that serve."""
    return (one for one in solution.construction.candidates if one.reason is None)


def off(what: str, found: float, wanted: float) -> str:
    """What is wrong, or nothing."""
    return "" if abs(found - wanted) <= CLOSE * max(1.0, abs(wanted)) else f"{what}: {found}, asked {wanted}"


def first(found: Iterator[str]) -> str:
    """The first that is wrong."""
    return next((text for text in found if text), "")

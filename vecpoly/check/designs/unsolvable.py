"""What is concluded of a synthesis that no linkage solves: why each candidate is rejected, and what is admissible."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...designs.base import Design
from ...designs.crank_rocker import CrankRocker
from ...designs.slider_crank import SliderCrank
from ...errors import AssemblyError
from ...oracle.synthesis.registry import design_answers, linkages, solvable
from ...problem.problem import Problem
from ...words import Words
from .admissible import admissible


def conclusion(problem: Problem) -> Words | None:
    """The reasons, each with the numbers of its candidates, and a range where one is known; None where there is a
    solution after all, and of other problems."""
    design = problem.subject
    if not isinstance(design, Design) or solvable(design):
        return None
    told, found = Words("没有机构满足所给条件。", "No linkage satisfies the conditions."), linkages(design)
    if found:
        told += Words("", " ") + rejected((number, one.verdict.value) for number, one in enumerate(found, 1))
    return told + (admissible(design) or _none_alone(design))


def answered_or_ranged(design: Design) -> Mapping[str, float]:
    """The exact answers; raises AssemblyError with where a datum had to lie, of data whose lines do not meet."""
    try:
        return design_answers(design)
    except AssemblyError as error:
        if isinstance(design, CrankRocker | SliderCrank) or (known := admissible(design)) is None:  # they tell it
            raise
        said = known.plain
        told = Words(f"；{said.zh.rstrip('。')}", f";{said.en.rstrip('.').replace(' With', ' with', 1)}")
        raise AssemblyError(error.words + told, code=error.code, numbers=error.numbers) from None


def _none_alone(design: Design) -> Words:
    """That nothing was found by changing one of the data; nothing where none is told of."""
    names = [datum.name for datum in design.varied()]
    if not names:
        return Words("", "")
    zh = _spaced("、".join(name.zh for name in names))
    return Words(
        f"单独改变{zh}中的任何一个，均未找到可用的机构；须同时改动几个数据。",
        f" Changing {' or '.join(name.en for name in names)} alone, none was found that serves: change several of the "
        "data.",
    )


def _spaced(told: str) -> str:
    """With a space where a letter stands beside a Chinese word."""
    return f"{' ' * told[0].isascii()}{told}{' ' * told[-1].isascii()}"


def rejected(candidates: Iterable[tuple[int, Words]]) -> Words:
    """The reasons for which candidates are rejected, each with their numbers."""
    reasons: dict[Words, list[str]] = {}
    for number, why in candidates:
        reasons.setdefault(why, []).append(str(number))
    told = [
        Words(
            f"候选解 {'、'.join(numbers)} 舍去：{why.zh}。",
            f"Candidate{'s' if len(numbers) > 1 else ''} {', '.join(numbers)} rejected: {why.en}.",
        )
        for why, numbers in reasons.items()
    ]
    return Words("".join(one.zh for one in told), " ".join(one.en for one in told))

"""What a step measures can be found on a sheet: both letters of a length at its ends, the symbol of a distance."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tests.drawn_library import IDS, drawn, hanging
from tests.each import each
from tests.found import FOUND
from vecpoly.algebra.formula import Over, Row, plain
from vecpoly.board.acts.inkless import Measure
from vecpoly.board.construction import Figure, Step
from vecpoly.board.paper.marks import Mark, Note, Point
from vecpoly.board.ruler import READABLE

NEAR = 0.6  # mm: a letter so near to an end of what is measured stands there
ANY = "k+1"  # of chords that are measured one by one and told by their sum, ΣQ_k Q_{k+1}: no segment has it
PRIMES = str.maketrans({"″": "′′", "‴": "′′′", "'": "′", "$": None, "{": None, "}": None, "^": None, "_": None})
LOW = str.maketrans({low: str(n) for n, low in enumerate("₀₁₂₃₄₅₆₇₈₉")})  # O₂ is O_2


def letter(text: str) -> str:
    """A letter as one compares it: its primes behind, ``n_2^′`` as ``n^′_2``."""
    bare = text.translate(PRIMES).translate(LOW).replace(" ", "")
    return bare.replace("′", "") + "′" * bare.count("′")


def letters(body: object) -> tuple[str, ...]:
    """The letters under one overline: of two points, or of a distance that has its own."""
    found: list[str] = []
    for item in body.items if isinstance(body, Row) else (body,):
        text = plain(item)  # type: ignore[arg-type]
        if found and set(text.translate(PRIMES)) == {"′"}:
            found[-1] += text  # O″: the primes are set upright
        else:
            found.append(text)
    return tuple(letter(text) for text in found)


def lettered(mark: Mark) -> Iterator[str]:
    """What a label names: of two points that coincide both."""
    text = mark.words.zh if isinstance(mark, Note) else getattr(mark, "label", "")
    yield letter(text)
    yield from (letter(part) for part in re.split(r"[,，≡=()（）、/]", text))


def overlined(steps: tuple[Step, ...]) -> set[tuple[str, ...]]:
    """Every length on paper that a line of the steps goes on with."""
    return {letters(one.body) for step in steps for one in hanging(step.formulas, Over)}


def short(name: str) -> set[str]:
    """What is measured, and is too short to be lettered: its step says so."""
    acts = drawn(name).construction.acts
    return {letter(act.key) for act in acts if isinstance(act, Measure) and act.mm < READABLE}


def undrawn(name: str) -> set[str]:
    """Arms that have no room on a free body: their step says so."""
    told = " ".join(step.words.zh for step in drawn(name).construction.steps)
    return {letter(one) for one in re.findall(r"力臂 \$(\S+)\$ 在机构图上长 \d+ mm，受力图上不画", told)}


def labels(figure: Figure) -> set[str]:
    return {text for mark in figure.marks for text in lettered(mark)}


@each((*IDS, *FOUND))
def test_what_a_step_measures_has_its_letters_on_a_figure(name: str) -> None:
    construction = drawn(name).construction
    shown, left = [labels(figure) for figure in construction.figures], short(name) | undrawn(name)
    for one in overlined(construction.steps):
        whole = letter("".join(one))
        if whole in left or one[-1].rstrip("′").endswith(ANY):
            continue
        on_one = any(all(part in there for part in one) or whole in there for there in shown)
        assert on_one, f"{''.join(one)} is measured, and no figure shows it"


@each(IDS)
def test_the_letters_of_a_length_stand_at_its_ends(name: str) -> None:
    construction = drawn(name).construction
    marks = [mark for figure in construction.figures for mark in figure.marks if isinstance(mark, Point)]
    pairs = {letter("".join(one)): one for one in overlined(construction.steps) if len(one) == 2}
    for act in construction.acts:
        if not isinstance(act, Measure) or act.mm < READABLE or letter(act.key) not in pairs:
            continue
        one, other = pairs[letter(act.key)]
        here, there = (_at(marks, end, act.b - act.a) for end in (act.a, act.b))
        told = f"{act.key} in step {act.head.step}"
        assert (one in here and other in there) or (one in there and other in here), told


def _at(marks: list[Point], end: complex, along: complex) -> set[str]:
    """The letters at an end of what is measured, or level with it, where the length is carried to the side."""
    level = along.conjugate() / abs(along)
    return {text for mark in marks if abs(((mark.at - end) * level).real) < NEAR for text in lettered(mark)}

"""What a step writes of a length on paper is what lies between these two letters on the polygon."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tests.drawn_library import IDS, LIBRARY, drawn, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Construction, View
from vecpoly.board.paper.marks import Point
from vecpoly.board.place import Place

POLYGONS = {"v": View.VELOCITY, "a": View.ACCELERATION}
READ = re.compile(
    r"= \(?μ_([va])\s*([a-z][^=/×A-Z()]*)\)?(?:/\(l_\w+\))? = \(?[\d.]+ × ([\d.]++)(?!×)"
)  # off a polygon, and how long
LENGTH = re.compile(r"([a-z][^=]*) = .*/.*= ([\d.]+) mm$")
NEARLY = 0.06  # mm: a length is written with four figures
Letter = tuple[str, str, int]  # the letter, its index, its primes


def half(written: str) -> float:
    """Half a unit of the last figure (mm): lengths to be laid off are written to 0.1 mm, shorter ones more finely."""
    return 0.5 * 10.0 ** -max(1, len(written.partition(".")[2])) + 1e-9


def letter(text: str) -> Letter:
    return text[0], "".join(char for char in text[1:] if char.isdigit()), text.count("′")


def lettered(construction: Construction, view: View) -> dict[Letter, list[complex]]:
    """Where each letter of a polygon stands."""
    figure = construction.figure(view)
    found: dict[Letter, list[complex]] = {}
    for mark in figure.marks if figure else ():
        if not isinstance(mark, Point):
            continue
        for part in mark.label.replace("，", ",").split(","):
            if part.strip()[:1].islower():
                found.setdefault(letter(part.strip()), []).append(mark.at)
    return found


def lengths_read(name: str) -> Iterator[tuple[str, tuple[Letter, Letter], float, str]]:
    """Of each length that a step takes off a polygon: v or a, its letters, how long (mm), and the line."""
    for line in (plain(node) for step in drawn(name).construction.steps for node in step.formulas):
        for scale, written, length in READ.findall(line):
            ends = re.findall(r"[a-z][^a-z]*", written.replace("\u2009", "").replace(" ", ""))
            if len(ends) == 2:  # two letters may stand at one end: ps_2,m
                yield scale, (letter(ends[0]), letter(ends[1])), float(length), line


def test_every_length_that_is_written_lies_between_its_letters() -> None:
    written, other = 0, []
    for name in IDS:
        construction = drawn(name).construction
        places: dict[Place | None, dict[Letter, list[complex]]] = {
            view: lettered(construction, view) for view in (View.VELOCITY, View.ACCELERATION)
        }
        for step in construction.steps:
            for line in (plain(node) for node in step.formulas if step.view in places):
                found = LENGTH.match(line)
                ends = (
                    [
                        letter(part)
                        for part in re.findall(r"[a-z][^a-z]*", found[1].replace("\u2009", "").replace(" ", ""))
                    ]
                    if found
                    else []
                )
                if not found or len(ends) != 2:
                    continue
                written += 1
                one, two = (places[step.view].get(end, []) for end in ends)
                if not any(abs(abs(p - q) - float(found[2])) < half(found[2]) for p in one for q in two):
                    other.append((name, step.number, line))
    assert written > 250 * len(IDS) / len(LIBRARY)
    assert other == []


@each(Later(ids))
def test_a_length_that_is_read_has_the_letters_that_stand_at_its_ends(name: str) -> None:
    construction = drawn(name).construction
    places = {scale: lettered(construction, view) for scale, view in POLYGONS.items()}
    for scale, letters, length, line in lengths_read(name):
        one, two = (places[scale].get(end, [0j] if end[0] == "p" else []) for end in letters)
        assert any(abs(abs(p - q) - length) < NEARLY for p in one for q in two), line


@each(Later(lambda: (*ids(), *FOUND)))
def test_two_lengths_of_a_polygon_have_not_the_same_letters(name: str) -> None:
    found: dict[tuple[str, frozenset[Letter]], float] = {}
    for scale, letters, length, line in lengths_read(name):
        assert abs(found.setdefault((scale, frozenset(letters)), length) - length) < NEARLY, line

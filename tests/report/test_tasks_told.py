"""A question sheet can be worked on by a student who has only it: where a file has no statement, its subject tells its
task, and every symbol that is given or asked is defined there, or beside the symbol itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from functools import cache

from tests.each import Later, each
from tests.found import APART, EVERY
from tests.generators.family import families, member
from vecpoly.designs.base import Design
from vecpoly.designs.base import kinds as designs
from vecpoly.devices.base import Device
from vecpoly.devices.base import kinds as devices
from vecpoly.errors import VecpolyError
from vecpoly.foundation.slotted import replace
from vecpoly.names import Named, Rel
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.library import library
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.report.content import beside_tables
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.ruled import NONE as BLANK
from vecpoly.report.statement.given_data import given_data
from vecpoly.report.statement.meant import meant_by
from vecpoly.report.statement.task import task
from vecpoly.report.values import asked_as, is_worded
from vecpoly.solution import solve
from vecpoly.words import Lang, Words

LANGS: tuple[Lang, ...] = ("zh", "en")
KINDS = {**devices(), **designs()}
NONE = Words.same("")
MEMBERS = range(2)  # of each family of random problems
_APART = re.compile(r"^(device|synthesis):", re.MULTILINE)
_FAMILIES = ("device-", "design-", "keys-", "engine", "field", "flywheel", "rotor", "run-up", "reduced")
_SIGN = re.compile(r"\$([^$]+)\$")
_SOLUTION = re.compile(r"\^\(\d\)$")
_PARTS = re.compile(r"[\s=≤<>+−/()]+")


def bare(symbol: str) -> str:
    return symbol.replace("{", "").replace("}", "")


def letters(text: str) -> set[str]:
    """Every symbol that a sentence has, as a whole and in its parts."""
    found = {bare(sign) for sign in _SIGN.findall(text)}
    return found | {part for sign in found for part in _PARTS.split(sign)}


def defined(symbol: str, known: set[str]) -> bool:
    """Whether the symbol is among these, by itself or by its index; a length by both its ends, or by a linkage of these
    letters, a quotient by both its parts."""
    one = _SOLUTION.sub("", bare(symbol))
    if known & {one, re.sub(r"\d+$", "i", one), re.sub(r"_.+$", "_i", one), one.removeprefix("l_")}:
        return True
    if "/" in one:
        return all(defined(part, known) for part in one.split("/"))
    if (bar := re.fullmatch(r"l_([A-Z])([A-Z])", one)) is None:
        return False
    chains = [each + each[:1] for each in known if re.fullmatch(r"[A-Z]{2,}", each)]
    ends = bar.groups()
    return {*ends} <= known or any(a + b in chain for chain in chains for a, b in (ends, ends[::-1]))


@cache
def untold() -> dict[str, Problem]:
    """Devices and tasks of synthesis without a statement: those of the library, those found, random ones."""
    texts = {entry.id: entry.path.read_text(encoding="utf-8") for entry in library()}
    texts |= {name: EVERY[name] for name in APART} | dict(random())
    found = {}
    for name, text in texts.items():
        if _APART.search(text):
            with suppress(VecpolyError):  # a random member that is refused is none
                found[name] = replace(loads(text), statement=NONE)
    return found


def random() -> Iterator[tuple[str, str]]:
    """Members of the families that write devices and tasks of synthesis."""
    for one in families():
        if one.name.startswith(_FAMILIES):
            yield from ((f"{one.name} {number}", member(one, 14, number)) for number in MEMBERS)


UNTOLD = Later(untold)


def everything_asked(problem: Problem) -> Problem:
    """The same problem, all asked of it that may be asked."""
    subject = problem.subject
    assert isinstance(subject, Device | Design)
    return replace(problem, asks=tuple(AskNamed(rel=one) for one in subject.quantities()))


def told(problem: Problem, lang: Lang) -> set[str]:
    """The symbols of the task, and of what is given in words."""
    words = [one.words.of(lang) for one in given_data(problem) if one.words is not None]
    return letters(" ".join([task(problem).of(lang), *words]))


@each(KINDS)
def test_every_device_and_every_synthesis_tells_its_task(kind: str) -> None:
    own = [task(problem) for problem in untold().values() if isinstance(problem.subject, KINDS[kind])]
    assert own
    assert all(one.zh.endswith("。") and one.en.endswith(".") and one.zh != one.en for one in own)


@each(UNTOLD)
def test_every_symbol_that_is_given_is_defined_where_no_statement_does(name: str) -> None:
    for problem in (untold()[name], everything_asked(untold()[name])):
        for lang in LANGS:
            known, data = told(problem, lang), [one.printed for one in given_data(problem) if one.words is None]
            alone = [sign for sign in data if not defined(sign, known)]
            assert not alone, (lang, alone, task(problem).of(lang))


@each(UNTOLD)
def test_every_symbol_that_is_asked_is_named_or_defined_where_no_statement_does(name: str) -> None:
    for problem in (untold()[name], everything_asked(untold()[name])):
        for lang in LANGS:
            known = told(problem, lang) | {_SOLUTION.sub("", bare(sign)) for sign in named(problem)}
            signs = [sign for ask in problem.asks for sign in nameless(ask.rel, lang)]
            alone = [sign for sign in signs if not defined(sign, known)]
            assert not alone, (lang, alone, task(problem).of(lang))


def named(problem: Problem) -> list[str]:
    """The symbols of what is asked by its name."""
    rels = [ask.rel for ask in problem.asks]
    return [one.symbol for one in rels if meant_by(problem.subject, one.key, f"${one.symbol}$") is not None]


def nameless(one: Named | Rel, lang: Lang) -> list[str]:
    """The symbols of a quantity that stand without a name where it is asked; of a verdict those that it is about."""
    name = asked_as(one.symbol, one.key, lang)
    if is_worded(one.key, one.unit):
        return [part for sign in _SIGN.findall(name) for part in _PARTS.split(bare(sign)) if part]
    return [one.symbol] if name == f"${one.symbol}$" else []


def test_what_a_synthesis_without_a_solution_is_asked_has_its_name_all_the_same() -> None:
    """γ_min alone, without its name, gave away that there is none."""
    lost, found = solve(loads(EVERY["drag-link-of-none"])), solve(load("drag-link"))
    assert not lost.answers and found.answers
    for lang in LANGS:
        names = [{row[0] for row in empty_table(one, lang).rows} for one in (lost, found)]
        assert names[0] == names[1]


def test_a_cell_that_is_left_over_of_two_blocks_is_shaded() -> None:
    rows = empty_table(solve(load("2-11")), "zh").rows
    assert rows[-1][:2] == (BLANK, BLANK) and all("" not in row[::2] for row in rows)


def test_a_jack_whose_load_is_sought_tells_the_load_for_which_its_polygon_is_drawn() -> None:
    assert "$Q_1$ = 1000 N" in beside_tables(solve(load("5-5")), "en")["given"]

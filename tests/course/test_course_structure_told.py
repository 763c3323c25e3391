"""Chapter 2 and the list of symbols of a course report: what they say is so, of every mechanism of the library."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache
from typing import Any

import pytest

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.laws import few
from tests.studies import studied
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import LinkNumber, Point, Role, Segment
from vecpoly.findings.study.study import Study, study
from vecpoly.mechanism.asked.forces import load_symbol
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.model import Prismatic, Revolute, Rolling
from vecpoly.report.content import Objects
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.structure.chapter import _pairs, _pins
from vecpoly.report.course.structure.groups_apart import apart
from vecpoly.report.course.structure.kinds import members
from vecpoly.report.course.structure.special_joints import concluded, special
from vecpoly.report.course.symbols import symbols
from vecpoly.report.flow.table import DataTable
from vecpoly.report.statement.structure import group_zh, kind_of

OTHERS = ("3-1f", "3-3", "dump-hoist", "scissor-lift", "excavator-boom")  # with them conclusions of every kind
SEVERAL = Later(lambda: (*few(ids(), 8), *OTHERS))
CLASSES = {"II": "Ⅱ", "III": "Ⅲ", "IV": "Ⅳ"}
NAMES = ("A-27", "B-24", "3-9", "3-5", "slider-crank-dynamic")


@cache
def found(name: str) -> Study:
    return study(drawn(name).solution)


@cache
def told(name: str) -> tuple[str, str]:
    said = list(special(found(name)))
    return "".join(words.zh for words in said), " ".join(words.en for words in said)


def several(name: str) -> dict[str, int]:
    """Letters at which more than two links are hinged, counted anew: links less one."""
    mech = found(name).mech
    thought = {contact.substitute for contact in mech.contacts}
    hinged: dict[str, set[str]] = {}
    for joint in mech.joints:
        if isinstance(joint, Revolute):
            hinged.setdefault(joint.point, set()).update({joint.a, joint.b} - thought)
    return {point: len(links) - 1 for point, links in hinged.items() if len(links) > 2}


@each(SEVERAL)
def test_compound_hinges_are_told_with_the_number_of_their_revolutes(name: str) -> None:
    zh, en = told(name)
    assert {p: int(n) for p, n in re.findall(r"\$(\w+)\$ \((\d+) revolutes\)", en)} == several(name)
    assert {p: int(n) for p, n in re.findall(r"\$(\w+)\$（(\d+) 个转动副）", zh)} == several(name)
    assert ("no multiple joint" in en) == ("无复合铰链" in zh) == (not several(name))


@each(SEVERAL)
def test_slots_rolling_and_higher_pairs_are_told_where_they_are_and_nowhere_else(name: str) -> None:
    (zh, en), mech = told(name), found(name).mech
    pins = [
        j.pin for j in mech.joints if isinstance(j, Prismatic) and j.pin_in_slot and j.block not in mech.substitutes
    ]
    rolls = any(isinstance(j, Rolling) for j in mech.joints)
    touching = [contact.point for contact in mech.contacts]
    at_slots, at_contacts = r"The pin in the slot at (.*?) is", r"(?:^|\. +)(\$\w+\$[^.]*?) is a higher pair; for"
    for sentence, letters in ((at_slots, pins), (at_contacts, touching)):
        said = re.search(sentence, en)
        assert (said is not None) == bool(letters)
        assert said is None or re.findall(r"\$(\w+)\$", said[1]) == letters
    assert ("Pure rolling" in en) == ("纯滚动副" in zh) == rolls
    assert ("槽中滑动为高副" in zh) == bool(pins) and ("高副低代" in zh) == bool(mech.contacts)
    absent_zh, absent_en = zh.rpartition("机构中")[2], en.rpartition("There is ")[2]
    assert ("passive degree of freedom" in absent_en) == ("局部自由度" in absent_zh) == (not mech.contacts)
    assert "no redundant constraint" in absent_en and "虚约束" in absent_zh
    assert ("滚子绕自身轴线的转动为局部自由度" in zh) == bool(mech.welded)


@each(SEVERAL)
def test_the_conclusion_names_every_group_with_its_links_and_the_highest_class(name: str) -> None:
    it = found(name)
    groups, words = decompose(it.mech), concluded(it)
    for group in groups:
        links = members(it, group)
        assert not (group.dyad or group.ram) or len(links) == 2
        if group.dyad or group.ram or group.kind == "driven":
            assert f"{group_zh(group)}（构件" in words.zh and f"{kind_of(group).en}" in words.en
        assert f"（构件 {'、'.join(links)}）" in words.zh and f" {', '.join(links)})" in words.en
    kinds = {group.kind for group in groups}
    if all(group.dyad or group.ram or group.kind.startswith("class") for group in groups) and "driven" not in kinds:
        high = sorted((k.removeprefix("class ") for k in kinds if k.startswith("class")), key=list(CLASSES).index)
        top = high[-1] if high else "II"
        assert f"a class {top} mechanism" in words.en and f"故为 {CLASSES[top]} 级机构" in words.zh
    elif "driven" in kinds:
        assert "inside the group" in words.en and "在杆组之内" in words.zh
    else:
        assert "how a held gear turns" in words.en and "由纯滚动条件直接确定" in words.zh
    if not it.mech.drive.between:
        assert f"the driving link {it.mech.drive.link}" in words.en


def test_the_library_has_mechanisms_of_every_kind_of_conclusion() -> None:
    ends = Counter(concluded(found(name)).en.rsplit(" ", 1)[-1] for name in SEVERAL)
    assert set(ends) == {"mechanism.", "group.", "turns."} and min(ends.values()) >= 2


@cache
def listed(name: str, lang: Any = "en") -> list[tuple[str, str, str]]:
    """The rows of the list of symbols, down its left half and then its right one."""
    objects = Objects()
    symbols(studied(name), Press(lang, objects))
    (table,) = (one for one in objects.named.values() if isinstance(one, DataTable))
    left, right = ([tuple(map(str, row[k : k + 3])) for row in table.rows] for k in (0, 4))
    return [(a, b, c) for a, b, c in (*left, *right) if a]


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_the_list_of_symbols_has_what_the_report_uses(name: str) -> None:
    it, rows = studied(name), listed(name)
    told_of = {symbol: (words, unit) for symbol, words, unit in rows}
    assert len(told_of) == len(rows) and all(words and unit for words, unit in told_of.values())
    used = {*it.env, *(c.symbol for group in it.model.groups for c in group.constants)}
    for symbol, name_in_model in (("$G_1$", "G_1"), ("$G_2$, $G_3$", "G_2"), ("$σ$", "σ")):
        assert (symbol in told_of) == (name_in_model in used), symbol
    for symbol in told_of:
        for one in re.findall(r"\$([le]_\{\w+\}|[βψδ]_\{?\w+\}?)\$", symbol):
            assert one in used
    drawn_at = {figure.scale.symbol: figure.scale.per_mm for figure in it.solution.construction.figures}
    assert {symbol.strip("$"): unit for symbol, (_, unit) in told_of.items() if "μ" in symbol} == drawn_at
    views = {figure.view for figure in it.solution.construction.figures}
    parts = {one for symbol in told_of for one in re.findall(r"\$a\^(\w)\$", symbol)}
    terms = [symbol for step in it.solution.construction.steps if step.equation for symbol in step.equation.symbols]
    assert parts == {one for term in terms for one in re.findall(r"^a\^\{?([ntkr])", term.strip("$"))}
    assert not parts or View.ACCELERATION in views


@pytest.mark.parametrize("name", NAMES)
def test_the_list_of_symbols_is_the_same_list_in_both_languages(name: str) -> None:
    zh, en = listed(name, "zh"), listed(name)
    assert [row[0].replace("、", ", ") for row in zh] == [row[0] for row in en]
    assert [row[2] for row in zh] == [row[2] for row in en]
    assert all(re.search("[\u4e00-\u9fff]", row[1]) for row in zh) and not re.search("[\u4e00-\u9fff]", str(en))


def test_no_symbol_of_the_equations_is_that_of_a_load() -> None:
    """The sign of the assembly was once M beside the moment M."""
    it = studied("4-3a")
    assert it.problem.loads is not None
    loads = {load_symbol(load.name) for load in it.problem.loads.all}
    model = {*it.env, *(c.symbol for group in it.model.groups for c in group.constants)}
    assert "M" in loads and "σ" in model and not loads & model
    assert len({row[0] for row in listed("4-3a")}) == len(listed("4-3a"))


def test_loads_add_the_balancing_load_a_reaction_efficiency_and_friction_circles() -> None:
    told_of = {symbol: (words, unit) for symbol, words, unit in listed("4-3a")}
    assert told_of["$M$"] == ("the balancing load", "N·m") and told_of["$ρ$"][1] == "mm" and "$η$" in told_of
    reactions = [(symbol, words) for symbol, (words, _) in told_of.items() if symbol.startswith("$R_")]
    ((symbol, words),) = reactions
    (by, on) = re.findall(r"\d", symbol)
    assert words == f"force of link {by} on link {on}"
    assert not {"$ρ$", "$η$"} & {row[0] for row in listed("A-27")}


@each(("4-5", "4-7"))
def test_friction_circles_are_told_where_pins_rub_and_nowhere_else(name: str) -> None:
    loads = studied(name).problem.loads
    assert loads is not None
    assert ("$ρ$" in {row[0] for row in listed(name)}) == bool(loads.friction and loads.friction.pins)


@each(SEVERAL)
def test_no_two_joints_have_one_letter(name: str) -> None:
    mech = drawn(name).problem.mechanism
    letters = Counter(letter for letter, _, _ in (*_pins(mech), *_pairs(mech)))
    assert letters and max(letters.values()) == 1, letters


def test_a_group_with_a_higher_pair_is_joined_by_the_bar_that_stands_for_it() -> None:
    """Without it the group of a knife-edge follower fell in two: a centre here, a rod there."""
    _, group = apart(studied("D-3-knife"))
    bars = [mark for mark in group.marks if isinstance(mark, Segment) and mark.role is Role.HIDDEN]
    at = {mark.label: mark.at for mark in group.marks if isinstance(mark, Point)}
    assert [{bar.a, bar.b} for bar in bars] == [{at["O"], at["E"]}]
    assert any(isinstance(mark, LinkNumber) and mark.number == "K" for mark in group.marks)

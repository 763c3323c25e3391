"""The dimensions that a course report tells, and the order of its solution: nothing is left out, nothing told twice."""

from __future__ import annotations

import re
from itertools import combinations
from typing import Any

import pytest

from tests.presses import press
from tests.studies import studied
from vecpoly import oracle
from vecpoly.mechanism.model import FRAME
from vecpoly.report.course.modelling.dimensions import dimensions, listed, rounded
from vecpoly.report.course.modelling.order import order
from vecpoly.report.course.statement import known
from vecpoly.report.picture import picture

NAMES = ("A-27", "B-24", "3-9", "3-5")
LENGTH = re.compile(r"\$l_\{(\w)(\w)\}\$ = ([\d.]+)")


# -- dimensions -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*NAMES, "cam-roller", "jansen-leg"])
@pytest.mark.parametrize("lang", ["zh", "en"])
def test_every_distance_of_a_link_stands_in_nature_and_as_it_is_on_paper(name: str, lang: Any) -> None:
    it, kept = studied(name), press(lang)
    drawn = picture(it.problem, it.solution.construction, 130.0, 80.0)
    assert drawn is not None
    figure = rounded(drawn)
    dimensions(it, kept, figure)
    motion, scale = oracle.solve(it.mech), figure.scale.value
    bodies = {it.name(body): body for body in it.mech.bodies if body not in it.mech.substitutes}
    for head, nature, paper in kept.made[0].rows:
        link = bodies.get(head, FRAME)
        told = LENGTH.findall(nature)
        for (p, q, size), mm in zip(told, re.split("，|, ", paper), strict=True):
            apart = abs(complex(motion.position(p)) - complex(motion.position(q)))
            assert float(size) == pytest.approx(1e3 * apart, rel=6e-5)
            assert float(mm) == pytest.approx(apart / scale, abs=0.0501)
            assert f"l_{p}{q}" in given_symbols(name) or (f"l_{q}{p}" not in given_symbols(name) and p < q)
        assert {frozenset(one[:2]) for one in told} == apart_on(name, link)
    assert [row[0] for row in kept.made[0].rows] == [
        *(head for head, body in bodies.items() if apart_on(name, body)),
        *({"zh": ["机架"], "en": ["frame"]}[lang] if apart_on(name, FRAME) else []),
    ]


def given_symbols(name: str) -> set[str]:
    return {datum.symbol for datum in studied(name).problem.given.lengths}


def apart_on(name: str, link: str) -> set[frozenset[str]]:
    """The pairs of letters that are told of a link: all, of more than four those with the first."""
    mech = studied(name).mech
    points = dict(mech.frame if link == FRAME else mech.link(link).points)
    pairs = list(combinations(points, 2)) if len(points) <= 4 else [(next(iter(points)), p) for p in [*points][1:]]
    return {frozenset(pair) for pair in pairs if abs(points[pair[0]] - points[pair[1]]) > 1e-9}


def test_what_is_not_drawn_or_not_to_scale_has_no_table_of_dimensions() -> None:
    kept = press()
    sketch = picture(studied("3-9").problem, studied("3-9").solution.construction, 130.0, 80.0)
    assert dimensions(studied("3-9"), kept, None) == "" and sketch is not None and kept.made == []


# -- the order of solution --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_letter_is_found_once_and_none_is_taken_over_before_it_was_found(name: str) -> None:
    it, zh, en = studied(name), press("zh"), press("en")
    order(it, en)
    order(it, zh)
    known, lines = set(it.mech.frame), en.made[0].rows
    for n, (number, title, taken, gives) in enumerate(lines, 1):
        letters = re.findall(r"\$([A-Z])\$", taken)
        assert number == str(n) and title and set(letters) <= known
        new = set(re.findall(r"\$([A-Z])\$", gives))
        assert not new & known
        known |= new
    assert known == {*it.mech.frame, *(letter for link in it.mech.links for letter in link.points)}
    assert lines[0][2] == f"${it.turn.drive.symbol}$"
    assert [re.findall(r"\$[^$]*\$", " ".join(row)) for row in lines] == [
        re.findall(r"\$[^$]*\$", " ".join(row)) for row in zh.made[0].rows
    ]


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_a_length_of_the_table_of_dimensions_is_not_told_among_the_data_too(lang: Any) -> None:
    it, kept = studied("3-9"), press(lang)
    drawn = picture(it.problem, it.solution.construction, 130.0, 80.0)
    assert drawn is not None
    there = listed(it, rounded(drawn))
    told = known(it, kept, there)
    assert told["lengths"] and {"l_AB", "l_BD", "l_DE"} <= there
    assert not re.search(r"l_\{?(AB|BD|DE)", told["given"]) and "φ_1" in told["given"]
    assert re.search(r"l_\{?AB", known(it, kept)["given"])

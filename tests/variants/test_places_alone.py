"""Problems that ask for places alone, such as all instant centres, have variants like any other."""

from __future__ import annotations

from vecpoly.grading.key import Kind
from vecpoly.problem.load import loads
from vecpoly.variants.judge import deviation
from vecpoly.variants.look import Look, sketch_of
from vecpoly.variants.pilot import pilot

CENTRES = """
extends: 3-1e
id: own-centres
title: {zh: 瞬心, en: Centres}
vary: {AB: 80 mm .. 110 mm by 2 mm, s: 40 mm .. 70 mm by 2 mm}
"""


def test_instant_centres_alone_are_graded_and_tell_students_apart() -> None:
    problem = loads(CENTRES)
    found = pilot(problem)
    look = Look(problem, sketch_of(problem))
    places = [one for one in look.asked if one.kind is Kind.PLACE]
    assert found.passed > 0.5 and found.room > 5
    assert places and not found.standard.demoted & {one.key for one in places}
    assert look.places.shape == (len(look.slips) + 1, len(look.asked))


def test_a_place_near_the_origin_is_no_worse_drawn_than_one_far_away() -> None:
    problem = loads(CENTRES)
    assert {deviation(one) for one in Look(problem, sketch_of(problem)).asked if one.kind is Kind.PLACE} == {0.0}

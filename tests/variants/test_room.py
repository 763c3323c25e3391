"""How many students can be told apart is known before anything is drawn for them, and why somebody got nothing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from math import inf
from pathlib import Path

import pytest

from tests.batch.homework import made, ordered, people, piloted
from vecpoly import loads
from vecpoly.batch import drawing
from vecpoly.batch.classwork import make_class
from vecpoly.batch.register import Part
from vecpoly.batch.run.runners import Here
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.errors import VecpolyError
from vecpoly.foundation.slotted import replace
from vecpoly.grading.key import AnswerKey, Graded, Kind
from vecpoly.variants.conditions import Condition
from vecpoly.variants.obstacle import obstacle
from vecpoly.variants.pilot import Pilot, pilot
from vecpoly.variants.room import room
from vecpoly.variants.seeds import Seed
from vecpoly.variants.told import demoted

TRAIN = """\
title: {zh: 轮系, en: A train}
id: hw3
problems:
  - problem: train-ring
    vary: {omega_1: 10 rad/s ccw .. 30 rad/s ccw by 1 rad/s}
"""


def keys(*sizes: float) -> list[AnswerKey]:
    """Keys of one value each, with T = 1."""
    each = (
        Graded(key="v", symbol="v", kind=Kind.SCALAR, unit="m/s", block="", exact=one, allowed=1.0, asked=True)
        for one in sizes
    )
    return [AnswerKey(problem="p", quantities=(one,)) for one in each]


def test_room_is_unlimited_where_all_are_far_apart_and_for_one_where_all_are_alike() -> None:
    assert room(keys(0.0, 10.0, 20.0, 30.0), 3.0, 300) == inf
    assert room(keys(0.0, 1.0, 2.0, 2.5), 3.0, 300) == 1.0
    half = room(keys(0.0, 1.0, 100.0, 101.0), 3.0, 300)  # two pairs of six
    assert half == pytest.approx(14.07, abs=0.01)
    assert room(keys(0.0, 1.0), 3.0, 300) == inf  # two tell nothing


def test_values_along_one_range_fill_it_sooner_than_chance_would() -> None:
    """0 to 30 T, two of whom must be 3 T apart, so that at most 11 find a place; by pairs alone it would be some 24."""
    along = keys(*range(0, 31, 3), *range(1, 31, 3))
    assert 5 <= room(along, 3.0, 300) <= 11


def test_room_depends_on_how_far_values_are_apart_and_not_on_how_large_they_are() -> None:
    along = [*range(0, 31, 3), *range(1, 31, 3)]
    assert room(keys(*(1000.0 + one for one in along)), 3.0, 300) == room(keys(*along), 3.0, 300)


def test_where_few_of_the_draws_pass_more_of_them_tell_how_far_students_are_apart() -> None:
    """Three of twelve pass, and none of these tell anything; of the others that pass, no two differ by 3 T in two
    answers."""
    found = pilot(
        loads("id: few\nextends: K-crank-rocker-AD\nvary: {AD: 64 mm .. 76 mm by 2 mm, CD: 44 mm .. 76 mm by 2 mm}")
    )
    assert found.passed < 1 / 3 and found.room < 3


def test_a_class_far_larger_than_its_ranges_can_tell_apart_is_refused_before_anything_is_drawn(tmp_path: Path) -> None:
    with pytest.raises(VecpolyError, match=r"about \d+ of 20 students can be told apart"):
        made(tmp_path / "hw", people(range(20)), TRAIN)


def test_whoever_is_too_near_to_others_is_told_so_and_not_that_the_data_contradict_each_other(tmp_path: Path) -> None:
    """Five where some three have room: those who are left get the reason that is true."""
    with piloted():
        done = make_class(ordered(tmp_path / "hw", people(range(5)), TRAIN), Here(), lambda *_: None)
    assert done.refused and len(done.register.sheets) >= 2
    assert all("too near" in error.words.en for error in done.refused.values())


@pytest.mark.parametrize(("served_at", "served"), [(20, True), (10**6, False)])
def test_one_student_who_is_too_near_is_drawn_again_and_not_for_ever(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, served_at: int, served: bool
) -> None:
    """A class of three was called stuck after a round in which the last of them, alone, found nothing."""
    drawn_so_far: list[int] = []

    def found(_: object, waiting: Sequence[tuple[Seed, int]], *others: object) -> Iterator[tuple[Seed, list[Part]]]:
        for seed, start in waiting:
            drawn_so_far.extend((start, start + 1))
            yield seed, [part(n, 100.0 if n >= served_at else 0.0) for n in (start, start + 1)]

    def part(attempt: int, size: float) -> Part:
        return Part(problem="p", attempt=attempt, values={}, scales={}, key=keys(size)[0])

    monkeypatch.setattr(drawing, "_found", found)
    course = drawing.Course(problem=loads("extends: 3-9\nid: p"), fingerprint="", standard=of_friction().standard)
    new = Seed(assignment="a", problem="p", student="new", salt="")
    parts, refused = drawing.drawn(course, [new], {"old": part(0, 0.0)}, Here(), tmp_path, lambda *_: None)
    assert ("new" in parts, "new" in refused) == (served, not served)
    assert len(drawn_so_far) <= drawing.HOPELESS + 2


def test_where_all_that_is_asked_is_drawn_too_badly_it_is_told_by_how_much_each_scatters() -> None:
    text = """
id: small-train
title: {zh: 轮系, en: A train}
device: epicyclic
data: {sun: 30, planet: 20, ring: 70, m: 2 mm, omega_1: 15 rad/s ccw, omega_3: 0 rad/s}
find: [omega_H, i_1H]
vary: {omega_1: 10 rad/s ccw .. 25 rad/s ccw by 0.5 rad/s}
gate: {deviation: 10 %}
"""
    with pytest.raises(VecpolyError, match=r"at most 10 %\) = omega_H \d+ %, i_1H \d+ %") as told:
        pilot(loads(text))
    assert float(str(told.value.numbers["i_1H"])) > 0.1


def test_what_no_draw_passes_is_named() -> None:
    text = "extends: 3-9\nid: short\nscales: null\nfind: [v_C2B, v_E]\nvary: {phi: 20 deg .. 70 deg by 5 deg}\n"
    seed = Seed(assignment="a", problem="short", student="1", salt="")
    standard = pilot(loads(text)).standard
    narrow = loads(text + "gate: {vectors: 300 mm, alike: no}")
    assert obstacle(narrow, seed, standard) in (Condition.VECTORS, Condition.SHORT)


@cache
def of_friction() -> Pilot:
    """Seven coefficients of friction of a screw jack."""
    return pilot(loads('extends: "5-5"\nid: mine\nvary: {f: 0.08 .. 0.14 by 0.01}\n'))


def with_slips(hidden: frozenset[Slip] = frozenset(), twins: frozenset[frozenset[Slip]] = frozenset()) -> Pilot:
    """The same, with other slips that do not show."""
    found = of_friction()
    return replace(found, standard=replace(found.standard, hidden=hidden, twins=twins))


def test_no_more_are_told_apart_than_there_are_sets_of_values() -> None:
    """Seven coefficients of friction were enough for 19 students."""
    assert of_friction().room <= 7


def test_slips_that_no_answer_shows_are_told_as_a_marker_tells_them() -> None:
    slips = {Slip(Mistake.FORWARDS, "inversion"), Slip(Mistake.DROPPED, "mechanism rho_min:e")}
    said = demoted(with_slips(hidden=frozenset(slips)))
    hidden = next(words for words in said if "no answer shows" in words.en)
    assert "−ω is carried on with the motion" in hidden.en and "e is left out" in hidden.en
    assert not any(word in hidden.en + hidden.zh for word in ("mechanism", "inversion", "rho_min", "forwards"))


def test_a_slip_that_shows_on_one_figure_is_not_told_to_show_nowhere_for_another_figure() -> None:
    found = with_slips(hidden=frozenset({Slip(Mistake.REVERSED, "mechanism rho_min:e")}))
    assert any("e is laid off the wrong way" in words.en for words in demoted(found))
    found = replace(found, shown=frozenset({Slip(Mistake.REVERSED, "e")}))
    assert not any("e is laid off the wrong way" in words.en for words in demoted(found))


@pytest.mark.parametrize(("count", "en"), [(1, "1 pair of slips gives"), (2, "2 pairs of slips give the")])
def test_one_pair_of_slips_is_one(count: int, en: str) -> None:
    a, b, c = (Slip(mistake, "v_B") for mistake in (Mistake.DROPPED, Mistake.HALVED, Mistake.DOUBLED))
    twins = frozenset([frozenset((a, b)), frozenset((b, c))][:count])
    assert any(en in words.en for words in demoted(with_slips(twins=twins)))

"""What is exported for Moodle, read as its importer reads it: nothing is refused, and typed answers get their marks."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest

from tests.batch.moodle_reader import Question, RefusedError, imported
from tests.drawn_library import DRAFTED
from tests.each import each
from tests.grading.cases import key_of, problem_of
from tests.laws import few
from vecpoly.batch.moodle.answers import asked_of
from vecpoly.batch.moodle.quiz import Quizzes, left_out
from vecpoly.batch.register import Exercise, Part, Register, Sheet
from vecpoly.batch.student import Student
from vecpoly.errors import VecpolyError
from vecpoly.grading.key import Kind, is_count
from vecpoly.problem.values.vary import data_of
from vecpoly.words import Words

TOLD_IN_WORDS = ("2-8", "5-5", "7-2a", "8-4", "curv-1")
NOTHING_TO_ASK = ("8-8", "function-log")
TITLE = Words("全部 ~ 100 % & <更多> / #1", "All of it ~ 100 % & <more> / #1")


@cache
def of(name: str, lang: str) -> Register:
    """A class of one student with this problem."""
    key = key_of(name)
    part = Part(problem=name, attempt=0, values={}, scales=dict(key.scales), key=key)
    sheet = Sheet(sheet="S1", student=Student(number="2024001", name="Zoë O'Neil", team="M1"), parts=(part,))
    exercise = Exercise(id=name, data=data_of(problem_of(name)), fingerprint="")
    return Register(
        assignment="hw", salt="", title=TITLE, lang=lang, vecpoly="test", exercises=(exercise,), sheets=(sheet,)
    )


@each(dict.fromkeys((*few(DRAFTED, 10), *TOLD_IN_WORDS)))
def test_moodle_takes_the_questions_of_a_problem_and_gives_right_and_close_answers_their_marks(name: str) -> None:
    try:
        asked = asked_of(key_of(name))
    except VecpolyError:
        return  # drawn by no method on file: it has no key
    for lang in ("zh", "en") if asked else ():
        quizzes = Quizzes(of(name, lang))
        (whole,), alone = imported(quizzes.cloze()), imported(quizzes.numerical())
        assert len(alone) == len(asked) and len(whole.parts) >= len(asked)
        for one, question in zip(asked, alone, strict=True):
            assert question.name.endswith(one.key)
            (part,) = question.parts
            if part.sort == "numerical":
                marks = [part.mark(repr(one.exact + off * one.allowed)) for off in (0, 0.98, -0.98, 1.45, -1.45)]
                assert marks[:3] == [100, 100, 100]
                assert is_count(one) or min(marks[3:]) >= 20  # close, or the value of a mistake or of another solution
        numbers = [part for part in whole.parts if part.sort == "numerical"]
        sizes = [
            abs(one.exact) if one.kind is Kind.SIGNED else one.exact for one in asked if _is_number(alone, one.key)
        ]
        assert [part.mark(repr(size)) for part, size in zip(numbers, sizes, strict=True)] == [100] * len(numbers)


def _is_number(alone: tuple[Question, ...], key: str) -> bool:
    return any(one.name.endswith(f" {key}") and one.parts[0].sort == "numerical" for one in alone)


@pytest.mark.parametrize("name", NOTHING_TO_ASK)
def test_a_problem_of_which_moodle_can_mark_nothing_is_left_out_and_told(name: str) -> None:
    """A cloze question without a blank is refused, and with it all of the file."""
    one = of(name, "en")
    assert left_out(one) == (name,) and left_out(of("7-2a", "en")) == ()
    assert imported(Quizzes(one).cloze()) == imported(Quizzes(one).numerical()) == ()


SPOILT: tuple[tuple[Callable[[str], str], str], ...] = (
    (lambda text: text.replace("{2:NUMERICAL", "{1.5:NUMERICAL"), "what looks like a blank"),
    (lambda text: text.replace(":NUMERICAL:%100%", ":NUMERICAL:%100%+"), "no number in a blank"),
    (lambda text: text.replace("%100%", "%99%"), "fraction 99"),
    (lambda text: text.replace("%50%", "%33%"), "fraction 33"),
    (lambda text: text.replace("<idnumber>7-2a-S1</idnumber>", ""), "idnumber"),
    (lambda text: text.replace("@@PLUGINFILE@@/figure.svg", "@@PLUGINFILE@@/other.svg"), "pictures"),
    (lambda text: text.replace("$course$/top/", "$course$/"), "category"),
    (lambda text: text.replace('type="cloze"', 'type="klose"'), "type klose"),
)


@pytest.mark.parametrize(("spoil", "why"), SPOILT)
def test_the_reader_refuses_what_moodle_would(spoil: Callable[[str], str], why: str) -> None:
    text = Quizzes(of("7-2a", "en")).cloze().decode()
    assert spoil(text) != text and imported(text.encode())
    with pytest.raises(RefusedError, match=why):
        imported(spoil(text).encode())


def test_a_number_for_itself_without_tolerance_or_with_another_fraction_is_refused() -> None:
    text = Quizzes(of("7-2a", "en")).numerical().decode()
    for was, now in (('fraction="100"', 'fraction="97"'), ("<tolerance>", "<tolerance>±")):
        assert was in text
        with pytest.raises(RefusedError):
            imported(text.replace(was, now).encode())


def test_two_questions_of_one_number_in_a_category_are_refused() -> None:
    text = Quizzes(of("7-2a", "en")).cloze().decode()
    again = text[text.rindex("<question ") : text.index("</quiz>")]
    with pytest.raises(RefusedError, match="twice"):
        imported(text.replace("</quiz>", again + "</quiz>").encode())

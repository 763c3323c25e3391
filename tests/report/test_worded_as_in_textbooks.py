"""Claims about wording: nothing is said that no textbook would print."""

from __future__ import annotations

import re

from tests.drawn_library import drawn
from tests.each import each

ODD = (
    "likewise, from",
    "add up to nothing",
    "as they should",
    "to and fro",
    "is the time until then",
    "同理，由",
    "found anew",
    "换一个位置须另作",
    "the way in which",
    "it is where the two meet",
    "work is gained",
    "through its own pin",
    "two lines meet that its",
)


@each(["3-1d", "motor-run-up", "press-flywheel", "cam-moves-flat-arm", "2-6red"])
def test_no_step_is_worded_as_no_textbook_would(name: str) -> None:
    steps = drawn(name).construction.steps
    assert not [phrase for phrase in ODD for step in steps if phrase in step.words.en + step.words.zh]


@each(["3-1d", "3-1a"])
def test_what_is_remarked_of_a_centre_stands_in_no_brackets(name: str) -> None:
    steps = drawn(name).construction.steps
    assert not [step.words.en for step in steps if re.search(r"\) ?\(", step.words.en)]


@each(["cam-rocker"])
def test_a_place_found_by_trial_is_told_as_a_protractor_is_read(name: str) -> None:
    told = [step.words.zh for step in drawn(name).construction.steps if "试作" in step.words.zh]
    places = [number for words in told for number in re.findall(r"= ([\d.]+)° 处", words)]
    assert len(places) == 3 and all(len(number.partition(".")[2]) <= 1 for number in places)

"""Claims about wording: nothing is said that no textbook would print."""

from __future__ import annotations

import re

from tests.drawn_library import drawn
from tests.each import each

ODD = ("likewise, from", "add up to nothing", "as they should", "to and fro", "is the time until then", "同理，由")


@each(["3-1d", "motor-run-up", "press-flywheel"])
def test_no_step_is_worded_as_no_textbook_would(name: str) -> None:
    steps = drawn(name).construction.steps
    assert not [phrase for phrase in ODD for step in steps if phrase in step.words.en + step.words.zh]


@each(["3-1d", "3-1a"])
def test_what_is_remarked_of_a_centre_stands_in_no_brackets(name: str) -> None:
    steps = drawn(name).construction.steps
    assert not [step.words.en for step in steps if re.search(r"\) ?\(", step.words.en)]

"""What a student is asked tells nothing of the book: remarks on what is printed there are for the solution."""

from __future__ import annotations

import re

from tests.drawn_library import IDS, given
from tests.each import each

BOOK = re.compile(r"原书|原题|教材|印作|误印|所印|此计数|\bprinted\b|\bthe book\b|\bmisprint|as in the assignment")


@each(IDS)
def test_a_statement_tells_nothing_of_the_book(name: str) -> None:
    problem = given(name)
    said = [problem.title, *([problem.statement] if problem.statement is not None else [])]
    assert not any(BOOK.search(text) for words in said for text in (words.zh, words.en))

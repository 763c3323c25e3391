"""The quick YAML reader and the careful one tell the same of every text: values, places, mistakes."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pytest

from tests.fuzz.mutants import mutant
from vecpoly.errors import ProblemFileError
from vecpoly.problem.library import library
from vecpoly.problem.text import nodes
from vecpoly.problem.text.source import _parsed

TEXTS = [entry.path.read_text(encoding="utf-8") for entry in library()]


def told(texts: Iterable[str]) -> list[object]:
    """What is read of each, every value with its place, or why it is refused."""
    found: list[object] = []
    for text in texts:
        try:
            tree = _parsed(text, "file")
            found.append((tree.data, tree.places))
        except ProblemFileError as error:
            found.append(str(error))
    return found


def told_carefully(texts: Iterable[str]) -> list[object]:
    """The same by the careful reader alone."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nodes, "_quickly", lambda _: None)
        return told(texts)


def test_the_library_is_read_alike_and_most_of_it_quickly() -> None:
    some = TEXTS[::4]
    assert told(some) == told_carefully(some)
    assert sum(nodes._quickly(text) is not None for text in TEXTS) > 0.9 * len(TEXTS)


def test_damaged_files_are_read_or_refused_alike() -> None:
    rng, small = np.random.default_rng(11), [text for text in TEXTS if len(text) < 1000]
    damaged = [mutant(rng, small) for _ in range(60)]
    seen = told(damaged)
    assert seen == told_carefully(damaged)
    assert {type(one) for one in seen} == {str, tuple}


@pytest.mark.parametrize("text", ["id: x\ty", "{id: !, b: 2}", "[" * 2_100, "? " * 2_000])
def test_what_the_quick_reader_is_not_trusted_with_is_read_carefully(text: str) -> None:
    assert nodes._quickly(text) is None
    with pytest.raises(ProblemFileError):
        _parsed(text, "file")

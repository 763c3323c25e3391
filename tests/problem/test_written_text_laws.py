"""A law over the whole library: its files, typed on a Chinese keyboard,
are the same data at the same lines and columns."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from ruamel.yaml import YAML
from ruamel.yaml.tokens import (
    FlowEntryToken,
    FlowMappingEndToken,
    FlowMappingStartToken,
    FlowSequenceEndToken,
    FlowSequenceStartToken,
    ValueToken,
)

from tests.laws import few
from vecpoly.errors import ProblemFileError
from vecpoly.foundation.data import data_dir
from vecpoly.problem.text.source import parse

FILES = sorted(data_dir("problems").rglob("*.yaml"))
WIDE = {
    FlowEntryToken: ",，",
    ValueToken: ":：",
    FlowMappingStartToken: "{｛",
    FlowMappingEndToken: "}｝",
    FlowSequenceStartToken: "[［【",
    FlowSequenceEndToken: "]］】",
}


def punctuation(text: str) -> Iterator[tuple[int, str]]:
    """Where YAML's own punctuation stands, and what may stand there in full width."""
    for token in YAML(typ="rt", pure=True).scan(text):
        at = token.start_mark.index if token is not None else 0
        if type(token) in WIDE and text[at : at + 1] == WIDE[type(token)][0]:
            yield at, WIDE[type(token)]


def typed(text: str, spots: Sequence[tuple[int, str]], chance: random.Random, share: float) -> str:
    """The text with some of its punctuation in full width; behind a full-width colon no space is needed."""
    signs = list(text)
    for at, ways in spots:
        if chance.random() < share:
            signs[at] = chance.choice(ways[1:])
            if ways[0] == ":" and text[at + 1 : at + 2] == " " and chance.random() < 0.5:
                signs[at + 1] = ""
    return "".join(signs)


@pytest.mark.parametrize("path", few(FILES, 8), ids=lambda path: path.stem)
def test_a_file_in_full_width_is_the_same_file(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    plain = parse(text, "x")
    spots = tuple(punctuation(text))
    assert len(spots) > 5
    for seed, share in ((1, 1.0), (2, 0.3)):
        wide = parse(typed(text, spots, random.Random(seed), share), "x")
        assert wide.data == plain.data
        assert {at: place.line for at, place in wide.places.items()} == {
            at: place.line for at, place in plain.places.items()
        }


def damaged(text: str, chance: random.Random) -> tuple[str, int]:
    """The text without one of its closing brackets, and the line (from 1) of the opening one's collection."""
    ends = [(at, ways) for at, ways in punctuation(text) if ways[0] in "}]"]
    at, _ = chance.choice(ends)
    return text[:at] + text[at + 1 :], text[:at].count("\n") + 1


@pytest.mark.parametrize("path", few(FILES[::5], 4), ids=lambda path: path.stem)
def test_a_missing_bracket_is_told_at_its_line(path: Path) -> None:
    text, chance = path.read_text(encoding="utf-8"), random.Random(path.stem)
    for _ in range(4):
        broken, line = damaged(text, chance)
        with pytest.raises(ProblemFileError) as caught:
            parse(broken, "x")
        fault = caught.value.faults[0]
        assert fault.place is not None and fault.place.line == line, f"{line}: {caught.value}"

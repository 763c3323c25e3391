"""Every key that a problem file may have is written by a generator, whose members are judged; what only a generator
finds was always wrong."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import yaml

from tests.generators.family import families, member
from tests.generators.keys.written_keys import places
from tests.laws import soaking
from vecpoly.problem.editors import json_schema

AS_ONE_LIKES = ("near-", "used-", "retold-")  # members of other families once more
DEAR = {
    **dict.fromkeys(("keys-taken", "keys-slowest", "asked-centres"), 1),
    "keys-scales": 0,
    "library": 2,
    "keys-sides": 2,
    "keys-aliases": 8,
    "keys-printed": 3,
    "asked-points": 4,
}
MEMBERS, MANY = 6, 60
OF_MANY_DATA = ("device", "rotor", "design-crank", "design-slider")  # and quickly written
TAKEN = re.compile(r"\.(take|omega)$")  # of any task of synthesis: the same two keys
NO_ANSWER_HANGS_ON = {
    r"\.printed\[\]\.lost(=.*)?": "held against no answer of the problem, see tests/check/test_printed_lengths.py",
    r"\.errata.*|\.explain.*|\.title_block.*|\.salt": "texts, and what seeds the numbers of students",
    r"\.extends": "told by retold-extends, whose members are other problems once more",
    r"\.tables|\.loads\.\*\.size\.table": "files beside the problem: a member is a text alone",
    r"\.scales.*|\.sheet.*": "how it is drawn: keys-scales, whose members are drawn to be made, is sampled in the soak",
    r"\.vary.*|\.gate.*|\.problems.*": "variants and assignments: several problems; see tests/variants and tests/batch",
    r"\.(rules|rubric|points|totals)\b.*": "marks, see tests/grading",
    r"\.input\[\]\.(on|cylinder|length|s|v|a)": "a drive in a list is one that stands alone",
    r"\.links\.\*\.face\.right|\.masses\.\*\.(J|S\..*)|.*=squares|rotor.*density": "rare, in keys-sides ...",
}


def documents() -> Iterator[Any]:
    """Some members of every family, as YAML says them: every scalar is its text."""
    for one in families():
        if not one.name.startswith(AS_ONE_LIKES):
            usual = MANY if one.name.startswith(OF_MANY_DATA) else MEMBERS
            count = DEAR.get(one.name, usual) or (2 if soaking() else 0)
            for number in range(count):
                yield yaml.load(member(one, 1, number), Loader=getattr(yaml, "CBaseLoader", yaml.BaseLoader))


def test_every_key_of_the_schema_is_written_by_a_generator_but_for_what_no_answer_hangs_on() -> None:
    found = places(json_schema(), list(documents()))
    assert len(found) > 650 and sum(found.values()) > 500
    taken = {TAKEN.search(place)[0] for place, there in found.items() if there and TAKEN.search(place)}  # type: ignore[index]
    missing = [
        place
        for place, there in found.items()
        if not there and not any(re.fullmatch(known, place) for known in NO_ANSWER_HANGS_ON)
    ]
    assert [place for place in missing if not (TAKEN.search(place) and TAKEN.search(place)[0] in taken)] == []  # type: ignore[index]

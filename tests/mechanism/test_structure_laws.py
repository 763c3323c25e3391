"""Laws of structure: random mechanisms built group by group come apart again into the same groups;
counting and rank agree, and why."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly.devices.structure import Structure
from vecpoly.methods.devices.structure.count import count, freedom
from vecpoly.methods.devices.structure.groups import take_apart
from vecpoly.methods.devices.structure.replacement import replaced
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.oracle.devices.structure.match import assur, rank_of
from vecpoly.oracle.devices.structure.rank import determined, ranks

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP", "III", "IV")
LIMITED = settings(max_examples=often(20), derandomize=True)
LETTERS = [f"{letter}{digit}" for digit in ("", *"123456789") for letter in "ABCDEFGHIJKLMNPQRSTUVWXYZ"]


class Maker:
    """Builds a mechanism group by group: each group hangs on links that were there before it."""

    def __init__(self, seed: int) -> None:
        self.dice = np.random.default_rng(seed)
        self.joints: dict[str, str] = {}
        self.links = ["1"]
        self.groups: list[tuple[str, ...]] = []
        self.kinds: list[str] = []
        self.join("R", "1", "0")

    def join(self, form: str, a: str, b: str) -> None:
        x, y = self.dice.uniform(-200, 200, 2)
        along = f" along {self.dice.uniform(0, 360):.4f} deg" if form == "P" else ""
        self.joints[LETTERS[len(self.joints)]] = f"{form}({a}, {b}) at ({x:.4f}, {y:.4f}){along}"

    def parent(self) -> str:
        return str(self.dice.choice(["0", *self.links]))

    def add(self, kind: str) -> None:
        first = len(self.links) + 1
        if kind in ("III", "IV"):
            a, b, c, d = new = tuple(str(first + i) for i in range(4))
            inner = [(a, b), (a, c), (a, d)] if kind == "III" else [(a, b), (b, c), (c, d), (d, a)]
            outer = (b, c, d) if kind == "III" else (a, c)
            # of III link a carries three bars; of IV the links a, c of the four-sided contour hang on the rest
            old = [self.parent() for _ in outer]
            for one, two in inner:
                self.join("R", one, two)
            for one, parent in zip(outer, old, strict=True):
                self.join("R", one, parent)
        else:
            a, b = new = (str(first), str(first + 1))
            one, two = self.parent(), self.parent()
            for form, (link, other) in zip(kind, ((a, one), (a, b), (b, two)), strict=True):
                self.join(form, link, other)
        self.links += new
        self.groups.append(new)
        self.kinds.append(kind)

    def device(self) -> Structure:
        return Structure.model_validate({"joints": self.joints, "drivers": ["1"]})


def made(seed: int, kinds: list[str]) -> Maker:
    maker = Maker(seed)
    for kind in kinds:
        maker.add(kind)
    return maker


BUILT = st.builds(made, st.integers(0, 10**6), st.lists(st.sampled_from(KINDS), min_size=1, max_size=4))


@given(BUILT)
@LIMITED
def test_a_mechanism_built_group_by_group_comes_apart_into_the_same_groups(maker: Maker) -> None:
    found = take_apart(maker.device().chain, ("1",))
    assert found.complete and sorted(group.links for group in found.groups) == sorted(maker.groups)
    kinds = {group.links: group.kind or {3: "III", 4: "IV"}[group.rank] for group in found.groups}
    assert [kinds[links] for links in maker.groups] == maker.kinds
    assert found.rank == max({"III": 3, "IV": 4}.get(kind, 2) for kind in maker.kinds)


@given(BUILT)
@LIMITED
def test_matching_finds_the_groups_that_were_built(maker: Maker) -> None:
    chain = maker.device().chain
    parts = assur(chain, ("1",))
    assert parts is not None and sorted(parts) == sorted(maker.groups)
    assert [rank_of(chain, links) for links in maker.groups] == [
        {"III": 3, "IV": 4}.get(kind, 2) for kind in maker.kinds
    ]


@given(BUILT)
@LIMITED
def test_count_and_rank_agree_for_generic_mechanisms(maker: Maker) -> None:
    chain = maker.device().chain
    found = ranks(chain)
    assert found.freedom == freedom(chain) == count(chain, ("1",)).freedom == 1
    assert found.redundant == 0 and found.idle == () and determined(chain, ("1",))


@given(BUILT, st.integers(0, 10**6))
@settings(max_examples=often(10), derandomize=True)
def test_a_bar_more_locks_a_mechanism_and_a_pair_less_frees_it(maker: Maker, seed: int) -> None:
    maker.dice = np.random.default_rng(10**7 + seed)
    less = maker.device().chain
    less = type(less)(less.links, less.pairs[:-1])
    assert ranks(less).freedom == freedom(less) == 3
    maker.join("R", "x", "1")
    maker.join("R", "x", "0")
    more = maker.device().chain
    assert ranks(more).freedom == freedom(more) == 0 and not determined(more, ("1",))


# -- redundant constraints of the textbook: counted by their marks, and by rank ----------------------------------

PARALLELOGRAM = {
    "A": "R(0, 1) at (0, 0)",
    "B": "R(1, 2) at (20, 35)",
    "C": "R(2, 3) at (120, 35)",
    "D": "R(3, 0) at (100, 0)",
}
TRAMMEL = {
    "A": "R(1, 2) at (60, 0)",
    "A'": "P(1, 0) at (60, 0) along (1, 0)",
    "B": "R(2, 3) at (0, 80)",
    "B'": "P(3, 0) at (0, 80) along (0, 1)",
}
CAM = {"A": "R(0, 1) at (0, 0)", "D": "P(2, 0) at (0, 90) along (0, 1)", "K": "H(1 about (8, 5), 2 flat) at (8, 35)"}
REDUNDANT = {
    "third parallel crank": (PARALLELOGRAM | {"E": "R(2, 4) at (70, 35)", "F": "R(4, 0) at (50, 0)"}, ("4",), 1),
    "third and fourth parallel crank": (
        PARALLELOGRAM
        | {
            "E": "R(2, 4) at (70, 35)",
            "F": "R(4, 0) at (50, 0)",
            "G": "R(2, 5) at (50, 35)",
            "H": "R(5, 0) at (30, 0)",
        },
        ("4", "5"),
        2,
    ),
    "two guides": (
        PARALLELOGRAM | {"D": "P(3, 0) at (120, 35) along (1, 0)", "E": "P(3, 0) at (160, 35) along (1, 0)"},
        (),
        2,
    ),
    "two bearings": (PARALLELOGRAM | {"E": "R(0, 1) at (0, 0)"}, (), 2),
    "bar to the middle of a trammel": (TRAMMEL | {"C": "R(2, 4) at (30, 40)", "O": "R(4, 0) at (0, 0)"}, ("4",), 1),
    "pair of wedges": (
        {
            "A": "P(1, 0) at (0, 0) along (0, 1)",
            "B": "P(1, 2) at (20, 30) along (1, 1)",
            "C": "P(2, 0) at (60, 40) along (1, 0)",
        },
        (),
        1,
    ),
    "cam of constant breadth": (CAM | {"L": "H(1 about (8, 5), 2 flat) at (8, -25)"}, (), 1),
}


@pytest.mark.parametrize("name", REDUNDANT)
def test_what_the_textbook_calls_redundant_is_so_by_rank_in_a_second_position_too(name: str) -> None:
    joints, links, surplus = REDUNDANT[name]
    chain = Structure.model_validate({"joints": joints}).chain
    found, rank = count(chain, ("1",)), ranks(chain)
    assert tuple(sorted(link for part in found.repeated for link in part.links)) == links
    assert (found.redundant, found.freedom) == (surplus, 1) == (rank.redundant, rank.freedom)
    assert (
        rank.moved and not rank.singular and ranks(found.reduced).redundant == 0 and ranks(found.reduced).freedom == 1
    )


@pytest.mark.parametrize(
    ("name", "letter", "moved"),
    [
        ("third parallel crank", "F", "R(4, 0) at (46, 0)"),
        ("bar to the middle of a trammel", "C", "R(2, 4) at (36, 32)"),
        ("two guides", "E", "P(3, 0) at (160, 35) along (1, 0.1)"),
        ("cam of constant breadth", "L", "H(1 about (13, 5), 2 flat) at (13, -25)"),
    ],
)
def test_sizes_that_are_not_exact_make_a_real_constraint(name: str, letter: str, moved: str) -> None:
    chain = Structure.model_validate({"joints": REDUNDANT[name][0] | {letter: moved}}).chain
    assert count(chain, ("1",)).redundant == ranks(chain).redundant < REDUNDANT[name][2]
    assert count(chain, ("1",)).freedom == ranks(chain).freedom < 1


def test_a_singular_position_is_told_from_a_redundant_constraint() -> None:
    """A parallelogram folded flat: the rank is short there, and full a little further on."""
    flat = {"A": "R(0, 1) at (0, 0)", "B": "R(1, 2) at (40, 0)", "C": "R(2, 3) at (140, 0)", "D": "R(3, 0) at (100, 0)"}
    chain = Structure.model_validate({"joints": flat}).chain
    found = ranks(chain)
    assert found.singular and found.here == found.onward - 1
    assert (found.freedom, found.redundant) == (1, 0) == (count(chain).freedom, count(chain).redundant)


def test_a_play_of_the_second_order_is_no_freedom() -> None:
    """Two faces of a cam that is too broad touch on one normal: a small turn would be free, a larger one is not."""
    chain = Structure.model_validate({"joints": CAM | {"L": "H(1 about (8, 0), 2 flat) at (8, -25)"}}).chain
    found = ranks(chain)
    assert found.here < found.coordinates and not found.moved
    assert (found.freedom, found.redundant) == (0, 0) == (count(chain, ("1",)).freedom, count(chain, ("1",)).redundant)


def test_a_roller_is_idle_only_if_the_normal_passes_through_its_pin() -> None:
    joints = {"A": "R(0, 1) at (0, 0)", "B": "R(2, 3) at (5, 60)", "C": "P(3, 0) at (5, 100) along (0, 1)"}
    round_ = Structure.model_validate({"joints": joints | {"K": "H(1 about (5, 8), 2 about B) at (5, 48)"}}).chain
    off = Structure.model_validate({"joints": joints | {"K": "H(1 about (5, 8), 2 about (9, 60)) at (7.92, 46)"}}).chain
    assert [roller.link for roller in count(round_).rollers] == ["2"] == list(ranks(round_).idle)
    assert (count(round_).freedom, ranks(round_).freedom) == (1, 1)
    assert not count(off).rollers and not ranks(off).idle and (count(off).freedom, ranks(off).freedom) == (2, 2)


def test_a_flat_face_is_replaced_by_a_sliding_link() -> None:
    device = Structure.model_validate({"joints": CAM, "drivers": ["1"]})
    low = replaced(device.chain, device)
    (group,) = take_apart(low.chain, ("1",)).groups
    assert group.kind == "RPP" and ranks(low.chain).freedom == 1


def test_behind_a_pair_of_wedges_both_sides_find_the_same_groups() -> None:
    joints = REDUNDANT["pair of wedges"][0] | {
        "E": "H(2 about (80, 60), 3 about (60, 100)) at (70, 80)",
        "G": "R(3, 0) at (0, 100)",
    }
    device = Structure.model_validate({"joints": joints, "drivers": ["1"]})
    found, exact = count(device.chain, ("1",)), device_answers(device)
    taken = take_apart(replaced(found.reduced, device).chain, ("1",))
    assert (found.redundant, found.freedom, len(taken.groups), taken.rank) == (1, 1, 2, 2)
    assert [exact[key] for key in ("p_redundant", "F", "groups_1", "class_1")] == [1, 1, 2, 2]

"""Dataclasses whose `__init__` is written late are those of the standard library in all that one can see of them."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from dataclasses import FrozenInstanceError, field, fields, replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.board.paper.marks import Ink, Role, Segment
from vecpoly.foundation.slotted import _dataclass as late
from vecpoly.foundation.slotted import dataclass as quickly_made
from vecpoly.foundation.slotted import replace as quickly_replaced

DECORATORS: dict[str, Any] = {"late": late, "standard": dataclasses.dataclass}
MADE: dict[str, Any] = {}

for _name, _decorator in DECORATORS.items():

    @_decorator(frozen=True, slots=True)
    class Base:
        first: int
        second: str = "two"

    @_decorator(frozen=True, slots=True, kw_only=True)
    class Leaf(Base):
        third: list[int] = field(default_factory=list)
        hidden: float = field(default=0.5, repr=False, compare=False)
        double: int = field(init=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "double", 2 * self.first)

    Leaf.__qualname__ = Base.__qualname__ = "Leaf"
    MADE[_name] = Leaf

GIVEN = st.fixed_dictionaries(
    {"first": st.integers()},
    optional={"second": st.text(), "third": st.lists(st.integers(), max_size=2), "hidden": st.floats(allow_nan=False)},
)


def _seen(one: Any) -> tuple[object, ...]:
    told = tuple((f.name, f.type, f.init, f.repr, f.compare, f.kw_only) for f in fields(one))
    return (
        repr(one),
        dataclasses.asdict(one),
        told,
        type(one).__match_args__,
        type(one).__slots__,
        hasattr(one, "__dict__"),
    )


@given(GIVEN)
def test_what_is_made_is_told_alike(given: dict[str, Any]) -> None:
    mine, standard = (kind(**given) for kind in MADE.values())
    assert _seen(mine) == _seen(standard)


@given(GIVEN, GIVEN)
def test_two_are_equal_where_those_of_the_library_are(one: dict[str, Any], other: dict[str, Any]) -> None:
    (mine, theirs), (standard, standards) = ((kind(**one), kind(**other)) for kind in MADE.values())
    assert (mine == theirs) == (standard == standards) and mine == MADE["late"](**one) != standard


def test_positions_and_missing_values_are_counted_alike() -> None:
    assert _seen(MADE["late"](3, "x")) == _seen(MADE["standard"](3, "x"))
    too_few_or_many: list[tuple[Any, ...]] = [(), (1, "x", [])]
    for kind in MADE.values():
        for wrong in too_few_or_many:
            with pytest.raises(TypeError, match="argument"):
                kind(*wrong)


def test_each_gets_a_fresh_list() -> None:
    assert MADE["late"](1).third is not MADE["late"](1).third


def test_nobody_changes_one() -> None:
    mark = Segment(a=0j, b=1j, role=Role.LINK)
    for name in ("a", "new"):
        with pytest.raises(FrozenInstanceError, match=name):
            setattr(mark, name, 2j)
    with pytest.raises(FrozenInstanceError, match="a"):
        del mark.a
    assert replace(mark, a=2j).a == 2j and mark.a == 0j


@given(GIVEN, GIVEN)
def test_what_is_replaced_quickly_is_what_is_replaced(given: dict[str, Any], changes: dict[str, Any]) -> None:
    one = MADE["late"](**given)
    assert _seen(quickly_replaced(one, **changes)) == _seen(replace(one, **changes))


@given(st.floats(allow_nan=False), st.text(), st.integers())
def test_a_mark_replaced_quickly_is_as_frozen_as_its_kind(x: float, key: str, step: int) -> None:
    mark = Segment(a=0j, b=1j, role=Role.LINK)
    changes: dict[str, Any] = {"a": complex(x), "key": key, "step": step}
    found = quickly_replaced(mark, **changes)
    assert found == replace(mark, **changes) and type(found) is Segment and mark == Segment(a=0j, b=1j, role=Role.LINK)
    with pytest.raises(FrozenInstanceError, match="step"):
        found.step = 3  # type: ignore[misc]
    with pytest.raises(TypeError, match="nothing"):
        quickly_replaced(mark, nothing=1)  # type: ignore[call-arg]


def test_a_field_of_any_name_is_replaced() -> None:
    @quickly_made(frozen=True, slots=True)
    class Pair:
        one: int
        changes: int = 0

    assert quickly_replaced(Pair(1), one=2, changes=3) == Pair(2, 3)


def test_a_subclass_with_a_dictionary_is_made_as_what_it_is() -> None:
    class Told(Segment):
        pass

    told = Told(a=0j, b=1j, role=Role.LINK, key="AB")
    assert type(told) is Told and told.key == "AB" and type(quickly_replaced(told, key="")) is Told


def test_a_copy_and_a_pickle_are_equal_and_hash_alike() -> None:
    mark = Segment(a=0j, b=1j, role=Role.LINK, step=3)
    for again in (copy.copy(mark), copy.deepcopy(mark), pickle.loads(pickle.dumps(mark))):
        assert again == mark and hash(again) == hash(mark) and again.step == 3
    assert isinstance(mark, Ink) and mark != replace(mark, step=4)


def test_an_equality_of_its_own_is_kept() -> None:
    @DECORATORS["late"](frozen=True, slots=True)
    class Own:
        value: float = 1.0

        def __eq__(self, other: object) -> bool:
            return True

    assert Own() == 2 and hash(Own()) == hash(Own())

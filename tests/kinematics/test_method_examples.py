"""`vecpoly list methods` names a library problem for a method: solving it must use that method."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Never

import pytest

from tests.laws import few
from vecpoly import load
from vecpoly.methods import registry
from vecpoly.methods.registry import AnyMethod, Stage, methods

SHOWN = [method for method in methods() if method.example]


@cache
def used(example: str) -> frozenset[tuple[Stage, str]]:
    """The methods that a library problem calls, by stage and group."""
    seen: set[tuple[Stage, str]] = set()

    def spied(method: AnyMethod) -> AnyMethod:
        def draw(*args: Never) -> object:
            seen.add((method.stage, method.group))
            return method.draw(*args)

        return replace(method, draw=draw)

    with pytest.MonkeyPatch.context() as patch:
        for key, method in list(registry._METHODS.items()):
            patch.setitem(registry._METHODS, key, spied(method))
        load(example).solve()
    return frozenset(seen)


@pytest.mark.parametrize("method", few(SHOWN, 5), ids=lambda m: f"{m.stage.value}-{m.group}")
def test_the_example_of_a_method_uses_it(method: AnyMethod) -> None:
    assert (method.stage, method.group) in used(method.example)

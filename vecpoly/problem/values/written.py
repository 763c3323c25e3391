"""What a problem says, as frozen texts with their places: from it the problem is built anew with other values."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from ...foundation.frozen import FrozenMap
from ...foundation.slotted import dataclass
from ..schema.faults import Path, Place
from ..text.pairs import pair_of
from ..text.source import Tree, Value

_PAIRS = ("frame", "guesses")
_LISTED = ("links", "loads", "masses", "friction")  # each entry on a line of its own


@dataclass(frozen=True, slots=True)
class Written:
    """The values of a file upon those that it extends; a mapping is a FrozenMap, a list a tuple."""

    name: str
    data: FrozenMap[str, Any]
    places: FrozenMap[Path, Place]

    def tree(self) -> Tree:
        """Values that may be changed, and built from."""
        return Tree(self.name, thawed(self.data), dict(self.places))


def written_of(tree: Tree) -> Written:
    """What the tree says now: what was taken away by null is gone, two components in one text are two values."""
    data = {
        key: _paired(value) if key in _PAIRS else value
        for key, value in tree.data.items()
        if value is not None and key != "extends"
    }
    return Written(tree.name, frozen(data), FrozenMap(tree.places))


def _paired(value: Value) -> Value:
    return {letter: pair_of(pair) for letter, pair in value.items()} if isinstance(value, dict) else value


def frozen(value: Value) -> Any:
    """The same, so that nobody changes it."""
    match value:
        case Mapping():
            return FrozenMap({key: frozen(item) for key, item in value.items()})
        case list():
            return tuple(frozen(item) for item in value)
        case _:
            return value


def thawed(value: Any) -> Any:
    """The same in mappings and lists that may be changed."""
    match value:
        case Mapping():
            return {key: thawed(item) for key, item in value.items()}
        case tuple():
            return [thawed(item) for item in value]
        case _:
            return value


def text_of(data: Mapping[str, Value]) -> str:
    """A problem file that says this: a line for every key, and for every link, load, mass and pair with friction."""
    lines: list[str] = []
    for key, value in data.items():
        if key in _LISTED and isinstance(value, Mapping):
            lines += [f"{key}:", *(f"  {name}: {_flow(item)}" for name, item in value.items())]
        else:
            lines.append(f"{key}: {_flow(value)}")
    return "\n".join(lines) + "\n"


def _flow(value: Value) -> str:
    return json.dumps(thawed(value), ensure_ascii=False)

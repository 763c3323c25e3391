"""One file laid on another: what an `extends` changes."""

from __future__ import annotations

from pathlib import PurePath

from ..schema.faults import Path, Place
from .respelled import respelled
from .source import Tree, Value


def overlay(base: Tree, over: Tree) -> Tree:
    """`over` laid on `base`: mappings merged key by key, all else replaced;
    null takes a key away. The base's text follows the other's."""
    base, over = respelled(base), respelled(over, base)
    places = dict(base.places)
    text = f"{over.text.rstrip()}\n\n# ----- {PurePath(base.name).name} -----\n{base.text}"
    return Tree(
        over.name,
        _merge(base.data, over.data, (), places, over.places),
        places,
        text,
        (*over.files, *base.files),
        over.reach,
    )


def _merge(
    base: dict[str, Value], over: dict[str, Value], path: Path, places: dict[Path, Place], new: dict[Path, Place]
) -> dict[str, Value]:
    merged = dict(base)
    for key, value in over.items():
        here = (*path, key)
        if value is None:
            merged.pop(key, None)
        elif isinstance(value, dict) and isinstance(merged.get(key), dict):
            merged[key] = _merge(merged[key], value, here, places, new)
        else:
            merged[key] = value
            places.update({p: place for p, place in new.items() if p[: len(here)] == here})
    return merged

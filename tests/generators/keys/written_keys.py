"""Which keys the JSON Schema of problem files knows, and which of them stand in documents."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

Schema = dict[str, Any]
Found = Iterator[tuple[str, bool]]


def places(schema: Schema, documents: Sequence[Any]) -> dict[str, bool]:
    """Every key and every word that a key may have, by its place, and whether it stands in one of the documents; what
    `data` hold stands under the device or the task of synthesis."""
    found: dict[str, bool] = {}
    for place, there in _all(schema, documents):
        found[place] = found.get(place, False) or there
    return found


def _all(schema: Schema, documents: Sequence[Any]) -> Found:
    yield from _inside(schema, "", documents, schema, ())
    for branch in schema["allOf"]:
        [(key, said)] = branch["if"]["properties"].items()
        mine = [one["data"] for one in documents if one.get(key) == said["const"] and "data" in one]
        yield from _inside(branch["then"]["properties"]["data"], said["const"], mine, schema, ())


def _inside(part: Any, at: str, here: Sequence[Any], root: Schema, above: tuple[str, ...]) -> Found:
    """above: the definitions in which it stands, for a train of machines holds trains."""
    if not isinstance(part, dict):
        return
    if (name := part.get("$ref")) is not None and name not in above:
        yield from _inside(root["$defs"][name.removeprefix("#/$defs/")], at, here, root, (*above, name))
    for branch in (*part.get("anyOf", ()), *(one for one in part.get("allOf", ()) if "if" not in one)):
        yield from _inside(branch, at, here, root, above)
    yield from ((f"{at}={word}", word in here) for word in part.get("enum", ()) if isinstance(word, str))
    if isinstance(part.get("items"), dict):
        items = [item for one in here if isinstance(one, list) for item in one]
        yield from _inside(part["items"], f"{at}[]", items, root, above)
    yield from _keyed(part, at, [one for one in here if isinstance(one, dict)], root, above)


def _keyed(part: Schema, at: str, here: Sequence[dict[str, Any]], root: Schema, above: tuple[str, ...]) -> Found:
    named, patterns = part.get("properties", {}), part.get("patternProperties", {})
    ways: list[tuple[str, Any, Callable[[str], bool]]] = [(key, one, key.__eq__) for key, one in named.items()]
    for pattern, inner in patterns.items():
        ways.append(("<A>" if "properties" in inner else "<AB>", inner, partial(_unnamed, frozenset(named), pattern)))
    if isinstance(part.get("additionalProperties"), dict):
        ways.append(("*", part["additionalProperties"], partial(_unnamed, frozenset(named), "")))
    for name, inner, fits in ways:
        mine = [value for one in here for key, value in one.items() if fits(key)]
        yield f"{at}.{name}", bool(mine)
        yield from _inside(inner, f"{at}.{name}", mine, root, above)


def _unnamed(named: frozenset[str], pattern: str, key: str) -> bool:
    """Whether a key is none of those with a name of their own, and fits the pattern."""
    return key not in named and re.search(pattern, key) is not None

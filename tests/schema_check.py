"""A small checker of JSON Schema, as far as ours goes: which places of a document break it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

TYPES: dict[str, tuple[type, ...]] = {
    "string": (str,),
    "object": (dict,),
    "array": (list,),
    "number": (int, float),
    "integer": (int,),
    "boolean": (bool,),
    "null": (type(None),),
}
KNOWN = {
    "type",
    "properties",
    "patternProperties",
    "additionalProperties",
    "required",
    "anyOf",
    "allOf",
    "not",
    "if",
    "then",
    "else",
    "enum",
    "const",
    "pattern",
    "items",
    "prefixItems",
    "minItems",
    "maxItems",
    "minProperties",
    "propertyNames",
    "minimum",
    "maximum",
    "$ref",
    "$defs",
    "$schema",
    "$id",
    "description",
    "title",
    "default",
}


def errors(root: dict[str, Any], schema: Any, value: Any, at: str = "") -> Iterator[str]:
    """Every place of the value that does not fit."""
    if isinstance(schema, bool):
        yield from () if schema else (f"{at}: nothing may stand here",)
        return
    assert not schema.keys() - KNOWN, schema.keys() - KNOWN
    if "$ref" in schema:
        yield from errors(root, root["$defs"][schema["$ref"].removeprefix("#/$defs/")], value, at)
    yield from _of_itself(schema, value, at)
    yield from _in_branches(root, schema, value, at)
    if isinstance(value, dict):
        yield from _in_object(root, schema, value, at)
    if isinstance(value, list):
        before = schema.get("prefixItems", [])
        for i, item in enumerate(value):
            yield from errors(root, before[i] if i < len(before) else schema.get("items", True), item, f"{at}[{i}]")


def fits(root: dict[str, Any], schema: Any, value: Any) -> bool:
    return not any(True for _ in errors(root, schema, value))


def _is(value: Any, name: str) -> bool:
    return isinstance(value, TYPES[name]) and (not isinstance(value, bool) or name == "boolean")


def _of_itself(schema: dict[str, Any], value: Any, at: str) -> Iterator[str]:
    names = schema.get("type", [])
    if names and not any(_is(value, name) for name in ([names] if isinstance(names, str) else names)):
        yield f"{at}: {value!r} is no {names}"
    if "enum" in schema and value not in schema["enum"]:
        yield f"{at}: {value!r} is not in {schema['enum']}"
    if "const" in schema and (value != schema["const"] or isinstance(value, bool)):
        yield f"{at}: {value!r} is not {schema['const']!r}"
    if isinstance(value, str) and "pattern" in schema and not re.search(schema["pattern"], value):
        yield f"{at}: {value!r} does not match {schema['pattern']}"
    if isinstance(value, list) and not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", 10**9):
        yield f"{at}: {len(value)} items"


def _in_branches(root: dict[str, Any], schema: dict[str, Any], value: Any, at: str) -> Iterator[str]:
    for inner in schema.get("allOf", []):
        yield from errors(root, inner, value, at)
    if "anyOf" in schema and not any(fits(root, inner, value) for inner in schema["anyOf"]):
        yield f"{at}: {value!r} fits none of {len(schema['anyOf'])}"
    if "not" in schema and fits(root, schema["not"], value):
        yield f"{at}: must not be so"
    if "if" in schema:
        yield from errors(root, schema.get("then" if fits(root, schema["if"], value) else "else", True), value, at)


def _in_object(root: dict[str, Any], schema: dict[str, Any], value: dict[str, Any], at: str) -> Iterator[str]:
    yield from (f"{at}: {key} is missing" for key in schema.get("required", []) if key not in value)
    if len(value) < schema.get("minProperties", 0):
        yield f"{at}: too few keys"
    for key, item in value.items():
        yield from errors(root, schema.get("propertyNames", True), key, f"{at}.{key}")
        mine = [schema["properties"][key]] if key in schema.get("properties", {}) else []
        mine += [inner for pattern, inner in schema.get("patternProperties", {}).items() if re.search(pattern, key)]
        for inner in mine or [schema.get("additionalProperties", True)]:
            yield from errors(root, inner, item, f"{at}.{key}")

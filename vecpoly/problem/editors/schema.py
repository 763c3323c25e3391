"""The JSON Schema of problem and assignment files:
pydantic's, with patterns, descriptions, and what YAML writes as numbers or null."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from ...designs import base as designs
from ...devices import base as devices
from ...figures import scales
from ...units.patterns import NUMBER
from ...units.reading import Dim, PerMm
from ..read_ranges import SPAN, STEP
from ..schema.assignment import AssignmentSpec
from ..schema.marking import KEYS as MARKING
from ..schema.models import ProblemSpec
from ..text.respelled import OTHER_KEYS
from . import patterns
from .design_words import DESIGNS
from .device_words import DATA
from .machine_words import MACHINE
from .patterns import Schema, quantity
from .words import KEYS

ID = "urn:vecpoly:problem-file"
_LENGTH, _ANGLE = quantity(Dim.LENGTH), quantity(Dim.ANGLE)
_SCALE = "auto|自动"
_PER_MM = (Dim.MU_L, Dim.MU_V, Dim.MU_A, Dim.MU_F)
_VALUES = {
    "InputSpec.phi": patterns.angle_from(),
    "InputSpec.omega": patterns.omega(),
    "InputSpec.alpha": quantity(Dim.ALPHA),
    "InputSpec.s": _LENGTH,
    "InputSpec.length": _LENGTH,
    "InputSpec.v": quantity(Dim.SPEED),
    "InputSpec.a": quantity(Dim.ACCEL),
    "LoadSpec.size": patterns.size(),
    "LoadSpec.direction": patterns.angle_or_along(),
    "LoadSpec.k": patterns.either(Dim.STIFFNESS, Dim.TWIST),
    "LoadSpec.l_0": _LENGTH,
    "LoadSpec.phi_0": _ANGLE,
    "LoadSpec.preload": patterns.either(Dim.FORCE, Dim.MOMENT),
    "LoadSpec.c": patterns.either(Dim.DAMPING, Dim.DRAG),
    "TableSpec.area": quantity(Dim.AREA),
    "TableSpec.bore": _LENGTH,
    "FrictionSpec.rho": _LENGTH,
    "FrictionSpec.r": _LENGTH,
    "FrictionSpec.phi": _ANGLE,
    "FrictionSpec.V": _ANGLE,
    "FrictionSpec.f": patterns.number(),
    "FrictionSpec.f_v": patterns.number(),
    "RodSpec.diameter": _LENGTH,
    "RodSpec.density": quantity(Dim.DENSITY),
    "MassSpec.mass": quantity(Dim.MASS),
    "MassSpec.inertia": quantity(Dim.INERTIA),
    **{
        f"ScalesSpec.{key}": quantity(dim, _SCALE)
        for key, mu in scales().items()
        for dim in _PER_MM
        if dim.dimension == PerMm(mu.called, mu.unit, mu.example).dimension
    },
    **{f"GateSpec.{key}": _LENGTH if key == "vectors" else _ANGLE for key in ("vectors", "meetings", "dead_point")},
    **{f"GateSpec.{key}": patterns.number(rf"{NUMBER} *[%％]") for key in ("deviation", "slips", "apart")},
    "PrintedSpec.direction": _ANGLE,
    "Link.radius": _LENGTH,
    "Link.alpha": _ANGLE,
    "Link.phi": patterns.angle_from(),
    "Link.s": _LENGTH,
    "Link.length": _LENGTH,
    "Place.at": _LENGTH,
    "Place.left": _LENGTH,
    "Place.right": _LENGTH,
    "Place.length": _LENGTH,
    "Slot.left": _LENGTH,
    "Slot.right": _LENGTH,
    "Problem.joints": patterns.joints(),
    "Problem.branch": patterns.branch(),
}
_SEVERAL = {"links": "Link", "frame": "", "guesses": ""}


def json_schema() -> Schema:
    """The JSON Schema of a problem or an assignment file."""
    schema = ProblemSpec.model_json_schema()
    schema["allOf"] = []
    _with_data(schema, "device", devices.kinds())
    _with_data(schema, "synthesis", designs.kinds())
    schema = loose(schema)
    _with_assignments(schema)
    for name, spec in schema["$defs"].items():
        _finish(spec, name)
    for name, part in (("InputSpec", "input"), ("MassSpec", "masses"), ("FrictionSpec", "friction")):
        known = schema["$defs"][name]["properties"]
        known |= {written: known[key] for written, key in OTHER_KEYS[part].items()}
    for branch in schema["allOf"]:
        data = branch["then"]["properties"]["data"]
        _finish(data, next(iter(branch["if"]["properties"].values()))["const"])
        data["description"] = _said("Problem.data")
    _finish(schema, "Problem")
    for key in ("frame", "guesses"):
        schema["properties"][key]["additionalProperties"] = {
            "type": ["array", "null"],
            "items": _LENGTH,
            "minItems": 2,
            "maxItems": 2,
        }
    schema["properties"]["vary"]["additionalProperties"] = {
        "type": ["string", "null"],
        "pattern": rf" *{SPAN} .* *{STEP} *",
    }
    head = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": ID,
        "title": "vecpoly problem file",
        "description": "vecpoly 题目文件 / a vecpoly problem file",
    }
    return head | {key: value for key, value in schema.items() if key != "title"}


def _with_data(schema: Schema, key: str, kinds: Mapping[str, type[BaseModel]]) -> None:
    """Add `device`, or `synthesis`, and for each of them on file what its `data` hold."""
    schema["properties"] |= {key: {"enum": list(kinds)}, "data": {"type": "object"}}
    for name, kind in kinds.items():
        data = kind.model_json_schema()
        schema["$defs"] |= data.pop("$defs", {})
        schema["allOf"].append(
            {"if": {"properties": {key: {"const": name}}, "required": [key]}, "then": {"properties": {"data": data}}}
        )


def _with_assignments(schema: Schema) -> None:
    """A file that lists problems is an assignment;
    any other needs an id and says what it is about, or extends another."""
    whole = AssignmentSpec.model_json_schema()
    sheet = whole["properties"]
    schema["$defs"] |= whole["$defs"]
    changes = {"type": "object", "required": ["problem"], "properties": {"problem": loose({"type": "string"})}}
    schema["properties"] |= {
        "title_block": sheet["title_block"],
        "salt": loose(sheet["salt"]),
        **{key: sheet[key] for key in MARKING},
        "problems": {"type": "array", "minItems": 1, "items": {"anyOf": [loose({"type": "string"}), changes]}},
    }
    schema["required"] = ["title"]
    about = [
        {"required": ["extends"]},
        {"required": ["frame", "links", "input"]},
        {"required": ["device", "data"]},
        {"required": ["synthesis", "data"]},
    ]
    asked = {
        "properties": {
            "find": {"type": ["array", "null"], "items": {"anyOf": [patterns.symbols(), {"$ref": "#/$defs/FindSpec"}]}}
        }
    }
    problem = {
        "required": ["id"],
        "anyOf": about,
        "allOf": [{"if": {"anyOf": [{"required": ["device"]}, {"required": ["synthesis"]}]}, "else": asked}],
        "not": {"required": ["title_block"]},
    }
    schema |= {"if": {"required": ["problems"]}, "then": {"propertyNames": {"enum": list(sheet)}}, "else": problem}


def _finish(spec: Schema, name: str) -> None:
    """Patterns and descriptions of the keys;
    every key may be null, which takes it away from what is extended, and no key is a must there."""
    if name not in ("Problem", "PrintedSpec", "FindSpec", "Slot", "Item"):
        spec.pop("required", None)
    for group in ("properties", "patternProperties"):
        for key, value in spec.get(group, {}).items():
            place = f"{name}.{_kind(key, value) if group == 'patternProperties' else key}"
            _inside(value)
            made = _nullable(_VALUES.get(place) or value)
            spec[group][key] = made | {"description": _said(place)}
    spec.pop("title", None)
    spec.pop("description", None)  # of the class, for programmers


def _said(place: str) -> str:
    words = KEYS.get(place) or MACHINE.get(place) or DATA.get(place) or DESIGNS.get(place)
    if words is None:
        return place  # a test asks for its words
    return f"{words.zh} / {words.en}"


def _kind(key: str, value: Schema) -> str:
    """Of keys by pattern: two letters with a length, or one letter with a place."""
    return "point" if "properties" in value else "length"


def _inside(value: Any) -> None:
    """The objects without a name of their own that stand inside: texts, links, places, slots."""
    if isinstance(value, dict):
        keys = set(value.get("properties", ()))
        for mark, name in (
            ("block", "Link"),
            ("along", "Place"),
            ("through", "Slot"),
            ("zh", "Text"),
            ("problem", "Item"),
        ):
            if mark in keys:
                _finish(value, name)
                return
        for inner in value.values():
            _inside(inner)
        if isinstance(value.get("additionalProperties"), dict):
            value["additionalProperties"] = _nullable(value["additionalProperties"])
    elif isinstance(value, list):
        for inner in value:
            _inside(inner)


def loose(value: Any) -> Any:
    """Scalars are read as their text: where a text stands, a number may stand as well."""
    if isinstance(value, list):
        return [loose(inner) for inner in value]
    if not isinstance(value, dict):
        return value
    found = {key: loose(inner) for key, inner in value.items()}
    if found.get("type") == "string" and "enum" not in found:
        found["type"] = ["string", "number"]
    return found


def _nullable(value: Schema) -> Schema:
    match value:
        case {"enum": list(known)}:
            return value | {"enum": [*known, None], "type": ["string", "boolean", "null"]}
        case {"type": list(types)}:
            return value | {"type": [*types, *(["null"] if "null" not in types else [])]}
        case {"type": str(one)}:
            return value | {"type": [one, "null"]}
        case {"anyOf": list(ways)}:
            return value | {"anyOf": [*ways, *([{"type": "null"}] if {"type": "null"} not in ways else [])]}
    return {"anyOf": [value, {"type": "null"}]}

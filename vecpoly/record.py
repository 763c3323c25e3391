"""Solutions, problems, constructions, mechanisms to JSON and back: a dataclass under its name, a point as [x, y].

text = to_json(solution)
assert from_json(text, Solution) == solution
"""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from importlib import import_module
from math import isfinite
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel

from .board.place import View, view_named
from .errors import ArgumentError, VecpolyError
from .foundation.frozen import FrozenMap
from .foundation.plugins import each_module
from .words import Words

T = TypeVar("T")
# what they define may stand in a record, and nothing else
_MODULES = (
    "words",
    "names",
    "errors",
    "units.reading",
    "algebra.formula",
    "board.place",
    "board.paper.roles",
    "board.paper.known",
    "board.paper.bodies",
    "board.paper.marks",
    "board.acts.base",
    "board.acts.leaving",
    "board.acts.inkless",
    "board.candidates",
    "board.scale",
    "board.construction",
    "mechanism.dimensions.placements",
    "mechanism.assembly.start",
    "mechanism.assembly.statements",
    "mechanism.assembly.branch",
    "mechanism.joints",
    "mechanism.profiles",
    "mechanism.model",
    "mechanism.laws.windows",
    "mechanism.laws.sizes",
    "mechanism.laws.springs",
    "mechanism.loads",
    "mechanism.machine",
    "mechanism.counterweights",
    "mechanism.asked.curvature",
    "problem.values.seen",
    "problem.values.given",
    "problem.asked.asks",
    "problem.text.held",
    "problem.values.written",
    "problem.gate",
    "foundation.stock",
    "problem.ranges",
    "problem.problem",
    "check.alarm",
    "answer",
    "solution",
    "board.otherwise.slip",
)
_SPECIAL = ("point", "map", "dict", "set", "path", "bytes", "number", "model", "figure")


def to_json(thing: Any) -> str:
    """A problem, mechanism, construction or solution as a JSON text; raises ArgumentError for what is none of ours."""
    return json.dumps(_plain(thing), ensure_ascii=False, allow_nan=False)


def from_json(text: str, kind: type[T]) -> T:
    """What a JSON text holds; raises VecpolyError where that is nothing of this kind."""
    name = kind.__name__
    try:
        thing = _thing(json.loads(text))
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise VecpolyError(
            Words(f"此 JSON 不是 {name}：{error}", f"this JSON holds no {name}: {error}"), code="no record"
        ) from None
    if not isinstance(thing, kind):
        raise VecpolyError(
            Words(
                f"此 JSON 是 {type(thing).__name__}，不是 {name}",
                f"this JSON holds a {type(thing).__name__}, not a {name}",
            ),
            code="no record",
        )
    return thing


@cache
def _classes() -> Mapping[str, type]:
    """Every class that a record may hold, by its name; where two have one name, the second with its module."""
    found: dict[str, type] = {}
    data = (name.partition(".")[2] for of in ("devices", "designs") for name in each_module(f"{__package__}.{of}"))
    for part in (*_MODULES, *data):
        module = import_module(f".{part}", __package__)
        for name, kind in vars(module).items():
            if (
                isinstance(kind, type)
                and kind.__module__ == module.__name__
                and (is_dataclass(kind) or issubclass(kind, Enum | BaseModel))
            ):
                found[f"{part}.{name}" if name in found else name] = kind
    return found


@cache
def _names() -> Mapping[type, str]:
    return {kind: name for name, kind in _classes().items()}


def _name(thing: Any) -> str:
    # those at the door are ours too
    name = next((_names()[kind] for kind in type(thing).__mro__ if kind in _names()), None)
    if name is None:
        kind = type(thing).__name__
        raise ArgumentError(
            Words(
                f"{kind} 不能写成 JSON；可写题目、机构、作图和解答",
                f"a {kind} does not go to JSON; a problem, a mechanism, a construction or a solution does",
            ),
            code="kind",
        )
    return name


def _plain(thing: Any) -> Any:
    match thing:
        case Enum():
            return {"is": _name(thing), "value": thing.value}
        case View():
            return {"is": "figure", "name": thing.name}
        case None | str() | bool() | int():
            return thing
        case float():
            return float(thing) if isfinite(thing) else {"is": "number", "text": str(float(thing))}
        case complex():
            return {"is": "point", "at": [_plain(thing.real), _plain(thing.imag)]}
        case tuple() | list():
            return [_plain(item) for item in thing]
        case FrozenMap() | dict():
            return {
                "is": "map" if isinstance(thing, FrozenMap) else "dict",
                "items": [[_plain(key), _plain(value)] for key, value in thing.items()],
            }
        case frozenset():
            return {"is": "set", "items": sorted(thing)}
        case bytes():
            return {"is": "bytes", "text": base64.b64encode(thing).decode()}
        case Path():
            return {"is": "path", "text": str(thing)}
        case BaseModel():
            return {
                "is": "model",
                "of": _name(thing),
                "set": sorted(thing.model_fields_set),
                "items": {key: _plain(value) for key, value in thing},
            }
    told = {"is": _name(thing)}
    kept = (one.name for one in fields(thing) if one.metadata.get("kept", True))
    return told | {name: _plain(getattr(thing, name)) for name in kept}


def _thing(data: Any) -> Any:
    if isinstance(data, list):
        return tuple(_thing(item) for item in data)
    if not isinstance(data, dict):
        return data
    return _special(data) if data["is"] in _SPECIAL else _made(data)


def _special(data: dict[str, Any]) -> Any:
    """What is no class of ours."""
    match data["is"]:
        case "point":
            return complex(*(_thing(part) for part in data["at"]))
        case "figure":
            return view_named(data["name"])
        case "number":
            return float(data["text"])
        case "set":
            return frozenset(data["items"])
        case "bytes":
            return base64.b64decode(data["text"])
        case "path":
            return Path(data["text"])
        case "model":
            kind = _classes()[data["of"]]
            assert issubclass(kind, BaseModel)
            return kind.model_construct(
                set(data["set"]), **{key: _thing(value) for key, value in data["items"].items()}
            )
    items = {_thing(key): _thing(value) for key, value in data["items"]}
    return FrozenMap(items) if data["is"] == "map" else items


def _made(data: dict[str, Any]) -> Any:
    """One of our classes of its fields."""
    kind = _classes()[data["is"]]
    if issubclass(kind, Enum):
        return kind(data["value"])
    return kind(**{key: _thing(value) for key, value in data.items() if key != "is"})

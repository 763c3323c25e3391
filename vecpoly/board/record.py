"""A construction to JSON and back: every dataclass under its name, every point as [x, y]."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

from .. import formula, words
from ..errors import VecpolyError
from ..words import Words
from . import acts, construction, marks, place
from .construction import Construction
from .place import View, view_named

_CLASSES = {
    name: kind for module in (formula, words, place, marks, acts, construction) for name, kind in vars(module).items()
    if isinstance(kind, type) and (is_dataclass(kind) or issubclass(kind, Enum))
}


def to_json(construction: Construction) -> str:
    """The construction as a JSON text."""
    return json.dumps(_plain(construction), ensure_ascii=False)


def from_json(text: str) -> Construction:
    """The construction of a JSON text; raises VecpolyError where the text holds none."""
    try:
        thing = _thing(json.loads(text))
    except (ValueError, TypeError, KeyError) as error:
        raise VecpolyError(Words(f"此 JSON 不是作图记录：{error}", f"this JSON holds no construction: {error}")) from None
    if not isinstance(thing, Construction):
        raise VecpolyError(Words(
            f"此 JSON 是 {type(thing).__name__}，不是作图记录",
            f"this JSON holds a {type(thing).__name__}, not a construction"))
    return thing


def _plain(thing: Any) -> Any:
    if isinstance(thing, View):
        return {"is": "View", "value": thing.name}
    if isinstance(thing, Enum):
        return {"is": type(thing).__name__, "value": thing.value}
    if is_dataclass(thing) and not isinstance(thing, type):
        return {"is": type(thing).__name__} | {f.name: _plain(getattr(thing, f.name)) for f in fields(thing)}
    if isinstance(thing, complex):
        return {"is": "point", "at": [thing.real, thing.imag]}
    if isinstance(thing, tuple):
        return [_plain(item) for item in thing]
    if isinstance(thing, Mapping):
        return {"is": "map", "items": {key: _plain(value) for key, value in thing.items()}}
    return thing


def _thing(data: Any) -> Any:
    if isinstance(data, list):
        return tuple(_thing(item) for item in data)
    if not isinstance(data, dict):
        return data
    name = data["is"]
    if name == "point":
        return complex(*data["at"])
    if name == "map":
        return {key: _thing(value) for key, value in data["items"].items()}
    if name == "View":
        return view_named(data["value"])
    kind = _CLASSES[name]
    if issubclass(kind, Enum):
        return kind(data["value"])
    return kind(**{key: _thing(value) for key, value in data.items() if key != "is"})

"""The JSON Schema of every kind of file: one with `parts` is a design project, one with `search` is a search."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from ..problem.editors import json_schema
from ..problem.editors.schema import loose
from ..project.spec import PartSpec, ProjectSpec, WorksSpec
from ..search.spec import KINDS, SearchSpec
from .words import PROJECT, SEARCH

Schema = dict[str, Any]


def file_schema() -> Schema:
    """The schema of a problem or an assignment, and beside it those of projects and searches, each by its own key."""
    problems = json_schema()
    head = {key: problems.pop(key) for key in ("$schema", "$id", "title", "description", "$defs")}
    others = {"if": {"required": ["search"]}, "then": _search(head["$defs"]), "else": problems}
    return {**head, "if": {"required": ["parts"]}, "then": _project(head["$defs"]), "else": others}


def _project(shared: Schema) -> Schema:
    """A part is a problem that says some things more, and may leave out what it takes from another."""
    whole = _of(ProjectSpec, shared)
    part = _of(PartSpec, shared)
    part["properties"]["works"] = _of(WorksSpec, shared)
    part.pop("additionalProperties", None)
    whole["properties"]["parts"] |= {"additionalProperties": part}
    whole["properties"]["schemes"]["items"] = {"type": "object"}
    whole["properties"]["demands"]["items"] = {"type": ["string", "object"]}
    return _told(whole, PROJECT)


def _search(shared: Schema) -> Schema:
    """Its data are those of what is sought."""
    whole = _of(SearchSpec, shared)
    whole["allOf"] = [
        {
            "if": {"properties": {"search": {"const": name}}},
            "then": {"properties": {"data": _told(_of(kind, shared), SEARCH)}},
        }
        for name, kind in KINDS.items()
    ]
    return _told(whole, SEARCH)


def _of(model: type[BaseModel], shared: Schema) -> Schema:
    """The schema of a model, as YAML writes its values; what it refers to stands with the rest."""
    found = model.model_json_schema()
    shared |= {name: spec for name, spec in found.pop("$defs", {}).items() if name not in shared}
    return dict(_untitled(loose(found)))


def _untitled(value: Any) -> Any:
    """Without the titles that are made of keys, which tell nothing."""
    match value:
        case list():
            return [_untitled(inner) for inner in value]
        case dict():
            told = ((key, inner) for key, inner in value.items() if key != "title" or not isinstance(inner, str))
            return {key: _untitled(inner) for key, inner in told}
    return value


def _told(schema: Schema, words: dict[str, str]) -> Schema:
    """Every key with its description in both languages."""
    for key, spec in schema["properties"].items():
        if key in words:
            schema["properties"][key] = spec | {"description": words[key]}
        if key == "parts":
            _told(spec["additionalProperties"], words)
        if key == "works":
            _told(schema["properties"][key], words)
    return schema

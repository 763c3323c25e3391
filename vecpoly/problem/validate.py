"""Pydantic's findings told in our words, with 'did you mean'."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from .faults import Faults, meant
from .schema import (
    FindSpec,
    FrictionSpec,
    InputSpec,
    LoadSpec,
    MassSpec,
    PrintedSpec,
    RodSpec,
    ScalesSpec,
    SheetSpec,
)

Model = TypeVar("Model", bound=BaseModel)

_MODELS: dict[str, type[BaseModel]] = {
    "input": InputSpec,
    "scales": ScalesSpec,
    "find": FindSpec,
    "printed": PrintedSpec,
    "sheet": SheetSpec,
    "loads": LoadSpec,
    "friction": FrictionSpec,
    "masses": MassSpec,
}
_SAID = {
    "string_type": "a text is expected here",
    "list_type": "a list is expected here, e.g. [v_C, a_C]",
    "dict_type": "a mapping (key: value) is expected here",
    "model_type": "a mapping (key: value) is expected here",
    "tuple_type": "two values are expected here, e.g. [100 mm, 0 mm]",
    "too_short": "at least one entry is needed here",
    "too_long": "two values are expected here, e.g. [100 mm, 0 mm]",
}
_UNION = {"str", "InputSpec", "list[InputSpec]", "FindSpec", "dict[str,any]"}


def validate(model: type[Model], data: Any, faults: Faults, *below: str) -> Model:
    """The data, found below this path of the file, as this model; raises ProblemFileError with every fault."""
    try:
        return model.model_validate(data)
    except ValidationError as error:
        for item in _best(error):
            path = tuple(
                step for step in item["loc"] if step not in _UNION and not str(step).startswith("tuple[")
            )
            faults.found.append(((*below, *path), _say(model, path, item)))
    faults.found[:] = list(dict.fromkeys(faults.found))
    faults.settle()
    raise AssertionError("validation failed without a fault")  # pragma: no cover


def _best(error: ValidationError) -> list[Any]:
    """Of a union's branches keep the one that fits the kind of value written."""
    items: list[Any] = list(error.errors())
    wrong_branch = ("string_type", "list_type", "model_type")
    kept = [item for item in items if item["type"] not in wrong_branch or not _UNION & set(item["loc"])]
    return _without_echo(kept or items[:1])


def _without_echo(items: list[Any]) -> list[Any]:
    """A misspelt key is one fault: not also the missing key that it was meant to be."""
    unknown = {item["loc"] for item in items if item["type"] == "extra_forbidden"}

    def echoed(loc: tuple[Any, ...]) -> bool:
        near = [str(other[-1]) for other in unknown if other[:-1] == loc[:-1]]
        return bool(get_close_matches(str(loc[-1]), near, cutoff=0.6))

    return [item for item in items if item["type"] != "missing" or not echoed(item["loc"])]


def _say(model: type[BaseModel], path: tuple[str | int, ...], item: Any) -> str:
    kind = item["type"]
    if kind == "extra_forbidden":
        keys = _model_at(model, path[:-1]).model_fields
        return f"unknown key '{path[-1]}'{meant(str(path[-1]), keys)}"
    if kind == "missing":
        if isinstance(path[-1], int):
            return "two values are expected here, e.g. [100 mm, 0 mm]"
        return f"'{path[-1]}' is missing"
    if kind == "string_pattern_mismatch":
        return f"'{item['input']}' may hold only letters, digits, '-', '_' and '.'"
    if kind == "value_error":
        return str(item["msg"]).removeprefix("Value error, ")
    if kind == "literal_error":
        return f"'{item['input']}' is not one of {item['ctx']['expected']}"
    if kind == "list_type" and isinstance(item["input"], str):
        return f"a list is expected here; write [{item['input']}]"
    return _SAID.get(kind, str(item["msg"]))


def _model_at(model: type[BaseModel], path: tuple[str | int, ...]) -> type[BaseModel]:
    if not path or str(path[0]) not in model.model_fields:
        return model
    return RodSpec if path[-1] == "rod" else _MODELS.get(str(path[0]), model)

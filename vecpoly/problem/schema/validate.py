"""Pydantic's findings told in our words, with 'did you mean'."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from types import UnionType
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError

from ...errors import FaultError
from ...words import Words
from .faults import Faults, meant

Model = TypeVar("Model", bound=BaseModel)

_PAIR = Words(
    "此处应为两个值，写在方括号中，以逗号分开", "two values are expected here, in brackets with a comma between"
)
_MAPPING = Words("此处应为映射（键: 值）", "a mapping (key: value) is expected here")
_SAID = {
    "string_type": Words("此处应为文本", "a text is expected here"),
    "dict_type": _MAPPING,
    "model_type": _MAPPING,
    "tuple_type": _PAIR,
    "too_short": Words("此处至少要有一项", "at least one entry is needed here"),
    "too_long": _PAIR,
    "float_parsing": Words("此处应为数", "a number is expected here"),
    "int_parsing": Words("此处应为整数", "a whole number is expected here"),
    "bool_parsing": Words("此处应为 true 或 false", "true or false is expected here"),
}
_SENTENCES = ("branch", "joints")
_LISTS = {
    "find": "[v_C, a_C]",
    "branch": "[C left of BD]",
    "joints": "[4 slides in 5]",
    "printed": "[{symbol: v_C, value: 0.18 m/s}]",
    "tables": "[table.csv]",
    "problems": "[3-8, 3-9]",
    "errata": "['...']",
    "explain": "['...']",
    "independent": "[bc2]",
    "first": "[v_C]",
    "columns": "[{head: No, holds: number}]",
    "motion": "[rise 30 mm in 120 deg cosine, dwell 30 deg, return in 120 deg sine, dwell 90 deg]",
}
_UNION = {"str", "InputSpec", "list[InputSpec]", "FindSpec", "TableSpec", "dict[str,any]"}


def validate(model: type[Model], data: Any, faults: Faults, *below: str) -> Model:
    """The data, found below this path of the file, as this model; raises ProblemFileError with every fault."""
    try:
        return model.model_validate(data)
    except ValidationError as error:
        for item in _best(error):
            path = tuple(step for step in item["loc"] if step not in _UNION and not str(step).startswith("tuple["))
            faults.note(_fault(model, path, item).under(*below))
    faults.settle()
    raise AssertionError("validation failed without a fault")  # pragma: no cover


def first_told(model: type[BaseModel], error: ValidationError) -> Words:
    """The first of what is wrong, with its place in the data: columns.0.head: ..."""
    item = _best(error)[0]
    return Words.same(f"{'.'.join(map(str, item['loc']))}: ") + _fault(model, item["loc"], item).words


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

    def lacks(item: Any) -> bool:
        """Whether a list counts as short only for its entries that are wrong."""
        own = item["loc"]
        return item["type"] == "too_short" and any(len(at) > len(own) and at[: len(own)] == own for at in places)

    places = [item["loc"] for item in items]
    kept = [item for item in items if not lacks(item)]
    return [item for item in kept if item["type"] != "missing" or not echoed(item["loc"])]


def _too_few(ctx: Mapping[str, int]) -> Words:
    least, there = ctx["min_length"], ctx["actual_length"]
    return Words(
        f"此处至少要有 {least} 项，现有 {there} 项",
        f"{least} entries are needed here, there {'is' if there == 1 else 'are'} {there}",
    )


_LETTER_WANTED = Words(
    "此处应为构件上一点的字母，如 at: G；点本身写在构件中，如 5: {EF: 200 mm, G: {along: EF, at: 80 mm}}",
    "the letter of a point of the link is expected here, as at: G; the point itself is set out in the link, as "
    "5: {EF: 200 mm, G: {along: EF, at: 80 mm}}",
)


def _fault(model: type[BaseModel], path: tuple[str | int, ...], item: Any) -> FaultError:
    written, reason = item["input"], (item.get("ctx") or {}).get("error")
    path = tuple(part for part in path if part != "[key]")  # the key itself is the place
    match item["type"]:
        case "value_error" if isinstance(reason, FaultError):
            return reason.under(*path)
        case "extra_forbidden":
            known = meant(str(path[-1]), _model_at(model, path[:-1]).model_fields)
            return FaultError(
                Words(f"未知的键“{path[-1]}”", f"unknown key '{path[-1]}'") + known, *path, code="unknown-key"
            )
        case "too_short" if item["ctx"]["min_length"] > 1:
            return FaultError(_too_few(item["ctx"]), *path)
        case "missing":
            text = _PAIR if isinstance(path[-1], int) else Words(f"缺少“{path[-1]}”", f"'{path[-1]}' is missing")
            return FaultError(text, *path, code="missing")
        case "string_pattern_mismatch":
            zh = f"“{written}”只能含字母（汉字也可）、数字、'-'、'_' 和 '.'"
            return FaultError(Words(zh, f"'{written}' may hold only letters, digits, '-', '_' and '.'"), *path)
        case "literal_error":
            expected = item["ctx"]["expected"]
            zh = f"“{written}”应为 {expected.replace(' or ', ' 或 ')} 之一"
            return FaultError(Words(zh, f"'{written}' is not one of {expected}"), *path, code="spelling")
        case "list_type" | "tuple_type" if item["type"] == "list_type" or _is_list(model, path):
            return FaultError(_list_wanted(path, written), *path, code="spelling")
        case "tuple_type" if len(path) == 2 and path[0] in ("frame", "guesses") and str(path[-1])[:1].isdigit():
            return FaultError(_outside(path[-1]), *path, code="spelling")
        case "model_type" if path[-1] in _model_at(model, path).model_fields:
            return FaultError(_below_a_name(path, written), *path, code="spelling")
        case "string_type" if path[0] == "loads" and path[-1] == "at":
            return FaultError(_LETTER_WANTED, *path, code="spelling")
        case "greater_than_equal" | "less_than_equal" | "greater_than" as kind:
            return FaultError(_bounded(kind, written, item["ctx"]), *path, code="range")
        case kind:
            return FaultError(_SAID.get(kind, Words(f"不能读取（{kind}）", str(item["msg"]))), *path)


def _outside(key: str | int) -> Words:
    return Words(
        f"“{key}”不在方括号内；坐标请写如 A: [100 mm, 0 mm]",
        f"'{key}' stands outside of brackets; write coordinates as A: [100 mm, 0 mm]",
    )


def _below_a_name(path: tuple[str | int, ...], written: Any) -> Words:
    """That a key stands where the name of its entry is expected: correct: {r: 150 mm}."""
    right = f"{path[-2] if len(path) > 1 else ''}: {{I: {{{path[-1]}: {written}}}}}"
    return Words(
        f"“{path[-1]}”应写在各项的名称之下，如 {right}", f"'{path[-1]}' stands below the name of an entry, as {right}"
    )


def _bounded(kind: str, written: Any, ctx: dict[str, Any]) -> Words:
    """That a number lies beyond its bound."""
    sign, zh, en = {
        "greater_than_equal": ("ge", "不小于", "not below"),
        "less_than_equal": ("le", "不大于", "not above"),
        "greater_than": ("gt", "大于", "above"),
    }[kind]
    bound = f"{ctx[sign]:g}"
    return Words(f"{written} 应{zh} {bound}", f"{written} must be {en} {bound}")


def _list_wanted(path: tuple[str | int, ...], written: Any) -> Words:
    """That a list is expected, and how what is written would be one."""
    if isinstance(written, str):
        return Words(f"此处应为列表；请写 [{written}]", f"a list is expected here; write [{written}]")
    sentences = isinstance(written, dict) and all(isinstance(text, str) for text in written.values())
    if sentences and path[0] in _SENTENCES:
        items = ", ".join(f"{key} {text}" for key, text in written.items())
        return Words(
            f"此处应为列表，每项是一句话；请写 [{items}]", f"a list of sentences is expected here; write [{items}]"
        )
    example = _LISTS.get(str(path[-1]) if path else "", "[..., ...]")
    return Words(f"此处应为列表；请写如 {example}", f"a list is expected here; write e.g. {example}")


def _model_at(model: type[BaseModel], path: tuple[str | int, ...]) -> type[BaseModel]:
    """The model of what stands at this path."""
    return next((kind for kind in _kinds_at(model, path) if _is_model(kind)), model)


def _is_list(model: type[BaseModel], path: tuple[str | int, ...]) -> bool:
    """Whether as many entries as one likes may stand at this path, not two."""
    return any(get_origin(kind) is tuple and ... in get_args(kind) for kind in _kinds_at(model, path))


def _kinds_at(model: type[BaseModel], path: tuple[str | int, ...]) -> tuple[Any, ...]:
    """What may stand at this path."""
    kinds: tuple[Any, ...] = (model,)
    for step in path:
        kinds = tuple(inner for kind in kinds for inner in _within(kind, step)) or kinds
    return kinds


def _within(kind: Any, step: str | int) -> Iterator[Any]:
    """What may stand below a key or index of this kind of value."""
    if _is_model(kind):
        if (known := kind.model_fields.get(str(step))) is not None:
            yield from _options(known.annotation)
    elif get_origin(kind) in (dict, Mapping):
        yield from _options(get_args(kind)[1])
    elif get_origin(kind) in (list, tuple):
        yield from _options(get_args(kind)[0])


def _options(annotation: Any) -> Iterator[Any]:
    """The kinds of a union; one by itself."""
    if get_origin(annotation) in (Union, UnionType):
        for one in get_args(annotation):
            yield from _options(one)
    elif get_origin(annotation) is Annotated:
        yield from _options(get_args(annotation)[0])
    else:
        yield annotation


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)

"""The kinds of value that a problem file holds, with what the JSON Schema says of them."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...words import Words
from ..text.commas import with_points
from ..text.pairs import pair_of

_LETTER = rf"(?:{LETTER}|[A-Z]_?[0-9])"
_QUANTITY = {"type": ["string", "number"], "description": "a number with its unit, e.g. 30 mm"}


def _words(value: Any) -> Words:
    match value:
        case Words():
            return value
        case str():
            return Words(value, value)
        case {"zh": str(zh), "en": str(en), **rest} if not rest:
            return Words(zh.strip(), en.strip())
        case {"zh": str(one), **rest} | {"en": str(one), **rest} if not rest:
            return Words.same(one.strip())
    raise FaultError(
        Words(
            "请写一个文本，或写 {zh: ..., en: ...}（可只写一种语言）；含逗号的文本要加引号",
            "write a text, or both {zh: ..., en: ...}; a text with a comma goes between quotes",
        ),
        code="out-of-range",
    )


Text = Annotated[
    Words,
    BeforeValidator(_words),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "string"},
                {
                    "type": "object",
                    "minProperties": 1,
                    "additionalProperties": False,
                    "properties": {"zh": {"type": "string"}, "en": {"type": "string"}},
                },
            ]
        }
    ),
]
Number = Annotated[str, WithJsonSchema(_QUANTITY)]
Name = Annotated[str, WithJsonSchema({"type": ["string", "integer"]})]
_PLACE = {
    "type": "object",
    "properties": {
        "along": {"type": "string"},
        "at": _QUANTITY,
        "left": _QUANTITY,
        "right": _QUANTITY,
        "angle": {"type": "string"},
        "side": {"type": "string", "pattern": "^(left|right) of "},
    },
    "patternProperties": {rf"^({_LETTER}|S\d+)({_LETTER}|S\d+)$": _QUANTITY},
    "additionalProperties": False,
}
_SLOT = {
    "anyOf": [
        {"type": "string", "pattern": f"^{_LETTER}$"},
        {
            "type": "object",
            "required": ["through"],
            "additionalProperties": False,
            "properties": {
                "through": {"type": "string"},
                "angle": {"type": "string"},
                "left": _QUANTITY,
                "right": _QUANTITY,
            },
        },
    ]
}
_ONE = {"type": "string", "pattern": f"^{_LETTER}$"}
Link = Annotated[
    Any,
    WithJsonSchema(
        {
            "type": "object",
            "properties": {
                "block": _ONE,
                "slot": _SLOT,
                "rod": _ONE,
                "cylinder": _ONE,
                "piston": _ONE,
                "gear": _ONE,
                "rack": _SLOT,
                "disc": _ONE,
                "cam": {"anyOf": [{"type": "string", "pattern": "^profile of "}, {"type": "object"}]},
                "face": _SLOT,
                "radius": _QUANTITY,
                "alpha": _QUANTITY,
                "phi": _QUANTITY,
                "s": _QUANTITY,
            },
            "patternProperties": {f"^{_LETTER}{_LETTER}$": _QUANTITY, f"^{_LETTER}$": _PLACE},
            "additionalProperties": False,
        }
    ),
]
Centre = Annotated[Any, WithJsonSchema({"anyOf": [_ONE, _PLACE]})]


def _pair(value: Any) -> Any:
    """Two components; three or four where decimal commas made them are told so."""
    parts = pair_of(value)
    several = isinstance(parts, list) and len(parts) > 2 and all(isinstance(part, str) for part in parts)
    if several and (said := with_points(parts)) is not None:
        raise FaultError(said, code="decimal-comma")
    return parts


Pair = Annotated[tuple[Number, Number], BeforeValidator(_pair)]
ID = r"^\w[\w.\-]*$"


def _yes(value: Any) -> bool:
    known = {"yes": True, "true": True, "是": True, "no": False, "false": False, "否": False}
    if isinstance(value, bool):
        return value
    if str(value).lower() not in known:
        raise FaultError(Words(f"“{value}”既不是 yes 也不是 no", f"'{value}' is neither yes nor no"), code="spelling")
    return known[str(value).lower()]


YesNo = Annotated[bool, BeforeValidator(_yes), WithJsonSchema({"enum": ["yes", "no", True, False]})]

"""What a problem file may hold: the pydantic models behind the checks and behind the JSON Schema for editors.

All scalars arrive as text; quantities are read later, by `units`, at their own place.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema

from ..words import Words

_LETTER = "[A-Z][a-z'′]?"
_QUANTITY = {"type": ["string", "number"], "description": "a number with its unit, e.g. 30 mm"}


def _words(value: Any) -> Words:
    match value:
        case Words():
            return value
        case str():
            return Words(value, value)
        case {"zh": str(zh), "en": str(en), **rest} if not rest:
            return Words(zh.strip(), en.strip())
    raise ValueError("write a text, or both {zh: ..., en: ...}; a text with a comma goes between quotes")


Text = Annotated[
    Words,
    BeforeValidator(_words),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "string"},
                {
                    "type": "object",
                    "required": ["zh", "en"],
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
    "patternProperties": {f"^{_LETTER}{_LETTER}$": _QUANTITY},
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
            "properties": {"block": _ONE, "slot": _SLOT, "rod": _ONE, "gear": _ONE, "radius": _QUANTITY},
            "patternProperties": {f"^{_LETTER}{_LETTER}$": _QUANTITY, f"^{_LETTER}$": _PLACE},
            "additionalProperties": False,
        }
    ),
]
Pair = tuple[Number, Number]


class Spec(BaseModel):
    """Base: unknown keys are faults."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class InputSpec(Spec):
    """The input: turning (phi, omega, alpha) or sliding (s, v, a)."""

    link: Name
    phi: Number | None = Field(None, description="60 deg, or 60 deg from AD")
    omega: Number | None = Field(None, description="10 rad/s ccw, 40 r/min 顺时针")
    alpha: Number | None = None
    s: Number | None = Field(None, description="travel along the guide from its origin")
    v: Number | None = None
    a: Number | None = None


class ScalesSpec(Spec):
    """Scales of the drawings: given, or auto."""

    mu_l: Number = "auto"
    mu_v: Number = "auto"
    mu_a: Number = "auto"


class FindSpec(Spec):
    """A point with a given velocity or acceleration, or the question for a Coriolis term."""

    point: str | None = None
    on: Name | None = None
    velocity: Pair | Number | None = None
    acceleration: Pair | Number | None = None
    coriolis: str | None = None


class PrintedSpec(Spec):
    """A printed answer."""

    symbol: str
    value: Number
    scale: Number | None = Field(
        None, description="where value is a length on paper: its scale, 0.006 (m/s)/mm"
    )
    direction: Number | None = None
    kind: Literal["calculated", "graphical"] = "calculated"
    note: Text | None = None


class SheetSpec(Spec):
    """The drawing sheet."""

    orientation: Literal["portrait", "landscape"]


class ProblemSpec(Spec):
    """A problem file."""

    id: str = Field(pattern=r"^[A-Za-z0-9][\w.\-]*$")
    title: Text
    extends: str | None = Field(None, description="id or path of a problem whose data are taken over")
    source: Text | None = None
    statement: Text = Words.same("")
    frame: dict[str, Pair] = Field(min_length=1)
    links: dict[str, Link] = Field(min_length=1)
    joints: list[str] = []
    input: InputSpec | list[InputSpec]
    branch: list[str] = []
    scales: ScalesSpec = ScalesSpec()
    find: list[str | FindSpec] = []
    printed: list[PrintedSpec] = []
    errata: list[Text] = []
    sheet: SheetSpec | None = None
    guesses: dict[str, Pair] = {}


class AssignmentSpec(Spec):
    """An assignment file: title, title block, problems."""

    title: Text
    title_block: dict[str, str] = {}
    problems: list[str | dict[str, Any]] = Field(min_length=1)


def json_schema() -> dict[str, Any]:
    """The JSON Schema of a problem file, for editors; a file that extends another may leave much out."""
    schema = ProblemSpec.model_json_schema()
    schema["required"] = ["id", "title"]
    schema["anyOf"] = [{"required": ["extends"]}, {"required": ["frame", "links", "input"]}]
    schema["$defs"]["InputSpec"].pop("required")
    schema["title"] = "vecpoly problem file"
    return schema

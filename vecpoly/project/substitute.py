"""`<linkage.CD / 2>` in the data of a part: what earlier parts gave, put in its place."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from ..errors import FaultError
from ..problem.schema.faults import Faults, Path
from ..problem.text.source import PROSE
from ..units.reckoning import Amount, reckon

_PLACE = re.compile(r"<([^<>]*)>")


def substituted(data: Mapping[str, Any], known: Mapping[str, Amount], faults: Faults, *at: str) -> dict[str, Any]:
    """The data with every `<expression>` in its place; faults at the path where one is wrong."""
    return {key: _value(value, known, faults, (*at, key)) for key, value in data.items()}


def _value(value: Any, known: Mapping[str, Amount], faults: Faults, path: Path) -> Any:
    if path[-1] in PROSE or path[-1] == "title":
        return value
    if isinstance(value, dict):
        return {key: _value(one, known, faults, (*path, key)) for key, one in value.items()}
    if isinstance(value, list):
        return [_value(one, known, faults, (*path, i)) for i, one in enumerate(value)]
    if not isinstance(value, str):
        return value
    try:
        return _PLACE.sub(lambda found: reckon(found[1], known).shown(), value)
    except FaultError as fault:
        faults.note(fault.under(*path))
        return value

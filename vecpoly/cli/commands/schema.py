"""vecpoly schema: the JSON Schema of every kind of file, with which editors complete and check it."""

from __future__ import annotations

import json

from ..files import STDOUT, put, spared
from ..options import JSON, OutOption


def schema(output: OutOption = None) -> None:
    """Print the JSON Schema of problem files, assignments, design projects and searches."""
    put(spared(output, JSON) or STDOUT, schema_text().encode())


def schema_text() -> str:
    """The schema as it is written."""
    from ...editors import file_schema

    return json.dumps(file_schema(), ensure_ascii=False, indent=2) + "\n"

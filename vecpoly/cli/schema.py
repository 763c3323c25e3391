"""vecpoly schema: the JSON Schema of a problem file, with which editors complete and check it."""

from __future__ import annotations

from .files import STDOUT, spared, write_json
from .options import JSON, OutOption


def schema(output: OutOption = None) -> None:
    """Print the JSON Schema of a problem file."""
    from ..problem.schema import json_schema

    write_json(json_schema(), spared(output, JSON) or STDOUT)

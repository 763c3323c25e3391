"""vecpoly schema: the JSON Schema of a problem file, with which editors complete and check it."""

from __future__ import annotations

import json

import typer

from .files import write_text
from .options import OutOption


def schema(output: OutOption = None) -> None:
    """Print the JSON Schema of a problem file."""
    if output is None:
        typer.echo(schema_text(), nl=False)
    else:
        write_text(output, schema_text())


def schema_text() -> str:
    """The schema as it is written."""
    from ..problem.editors import json_schema

    return json.dumps(json_schema(), ensure_ascii=False, indent=2) + "\n"

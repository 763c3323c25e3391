"""vecpoly schema: the JSON Schema of a problem file, with which editors complete and check it."""

from __future__ import annotations

import json

import typer

from .files import write_text
from .options import OutOption


def schema(output: OutOption = None) -> None:
    """Print the JSON Schema of a problem file."""
    from ..problem.schema import json_schema

    text = json.dumps(json_schema(), ensure_ascii=False, indent=2) + "\n"
    if output is None:
        typer.echo(text, nl=False)
    else:
        write_text(output, text)

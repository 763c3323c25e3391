"""Whether a file is a design project."""

from __future__ import annotations

from pathlib import Path

from ..problem.text.source import read


def is_project(path: Path) -> bool:
    """Does this file hold the parts of a project?"""
    data = read(path).data
    return "parts" in data and not {"links", "data", "problems"} & data.keys()

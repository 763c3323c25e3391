"""The commented file that `vecpoly new` writes."""

from __future__ import annotations

from pathlib import Path


def template_text() -> str:
    """A four-bar with comments in both languages; it loads and solves as it stands."""
    return Path(__file__).with_name("template.yaml").read_text(encoding="utf-8")

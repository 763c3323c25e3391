"""Members of the generators' families, as texts, of which a claim about every drawing did not hold when it was first
made of problems by lot (`python -m tests.by_lot`): such claims are made of them in every run."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

FOUND: Mapping[str, str] = {
    path.stem: path.read_text(encoding="utf-8") for path in sorted(Path(__file__).parent.glob("*.yaml"))
}

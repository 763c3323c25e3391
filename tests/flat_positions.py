"""Four positions whose construction is ill-conditioned: two centre points nearly fall together, lines meet flatly."""

from __future__ import annotations

from pathlib import Path

FLAT = str(Path(__file__).parent / "data" / "four-positions-flat.yaml")

"""Members of the generators' families of which a claim about every problem did not hold when it was first made of them
(`python -m tests.by_lot`): what was mended is claimed of them, too."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

_FILES = sorted((Path(__file__).parent / "data" / "found").glob("*/*.yaml"))
_ROOMS = {room: [file for file in _FILES if file.parent.name == room] for room in ("motion", "forces", "devices")}
FOUND: Mapping[str, str] = {
    file.stem: file.read_text(encoding="utf-8") for file in (*_ROOMS["forces"], *_ROOMS["motion"])
}  # of mechanisms
DEVICES: Mapping[str, str] = {file.stem: file.read_text(encoding="utf-8") for file in _ROOMS["devices"]}
FORCES = tuple(file.stem for file in _ROOMS["forces"])

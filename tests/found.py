"""Members of the generators' families of which a claim about every problem did not hold when it was first made of them
(`python -m tests.by_lot`): what was mended is claimed of them, too."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

_FILES = sorted((Path(__file__).parent / "data" / "found").glob("*/*.yaml"))
_FOLDERS = tuple((file.stem, file.parent.name) for file in _FILES)
EVERY: Mapping[str, str] = {file.stem: file.read_text(encoding="utf-8") for file in _FILES}
APART = tuple(name for name, folder in _FOLDERS if folder in ("devices", "designs"))  # what analyses no mechanism
FOUND: Mapping[str, str] = {name: text for name, text in EVERY.items() if name not in APART}
DEVICES: Mapping[str, str] = {name: EVERY[name] for name, folder in _FOLDERS if folder == "devices"}
FORCES = tuple(name for name, folder in _FOLDERS if folder == "forces")  # about loads

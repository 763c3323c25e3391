"""Where the package's data lie: at the top level of a checkout, or inside the wheel (vecpoly/_data)."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent


def data_dir(name: str) -> Path:
    """The folder `problems` or `templates`. Raises FileNotFoundError if the installation lacks it."""
    checkout = _PACKAGE.parent / "pyproject.toml"
    folder = _PACKAGE.parent / name if checkout.is_file() else _PACKAGE / "_data" / name
    if not folder.is_dir():
        raise FileNotFoundError(f"{folder} is missing; install vecpoly again")
    return folder

"""Where the package's data lie: inside the wheel (vecpoly/_data), or at the top level of a checkout."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path


def data_dir(name: str) -> Path:
    """The folder `problems` or `templates`. Raises FileNotFoundError if the installation lacks it."""
    package = Path(str(files("vecpoly")))
    for folder in (package.parent / name, package / "_data" / name):
        if folder.is_dir() and (folder.parent / "vecpoly" == package or folder.parent.name == "_data"):
            return folder
    raise FileNotFoundError(f"vecpoly's folder '{name}' is missing; install vecpoly again")

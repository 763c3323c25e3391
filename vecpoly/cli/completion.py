"""Shell completion: the ids of the library, with their titles beside them."""

from __future__ import annotations

from ..words import bare
from .tongue import tongue


def ids(incomplete: str) -> list[tuple[str, str]]:
    """The ids that begin so, in their order; where there is none, the shell completes names of files."""
    from ..problem.library import library

    return [(entry.id, bare(entry.title.of(tongue()))) for entry in library() if entry.id.startswith(incomplete)]

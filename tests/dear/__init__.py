"""Dear claims are tried in turns: `make test` takes a sixteenth of them, drawn anew with every change of the code.

What is drawn depends on the code alone, so that the same state of the project is tried by the same claims on every
machine, and every claim has its turn in one of sixteen states on average. `TURNS=1 make test` tries all of them, and so
does the soak; whoever names files or tests gets all that he names.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from hashlib import blake2b
from pathlib import Path
from zlib import crc32

HERE = Path(__file__).parent
LIST = HERE / "claims.txt"  # written by `python -m tests.dear`
TURNS = 16  # a dear claim is tried in one of so many states of the code
CODE = ("vecpoly", "templates", "problems")  # what is tried


def listed() -> dict[str, str]:
    """The functions of tests that are dear: the seconds that each took."""
    lines = LIST.read_text(encoding="utf-8").splitlines()
    return dict(line.split() for line in lines if not line.startswith("#"))


def turns() -> int:
    """Of how many turns this is one: `TURNS` of the environment."""
    return int(os.environ.get("TURNS", TURNS))


def state(root: Path) -> str:
    """The digest of the code as it stands."""
    digest = blake2b(digest_size=8)
    for folder in CODE:
        for file in sorted(one for one in (root / folder).rglob("*") if one.suffix in (".py", ".yaml", ".html", ".j2")):
            digest.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return digest.hexdigest()


def resting(names: Iterable[str], drawn_by: str, of: int) -> frozenset[str]:
    """The tests whose turn it is not, of these that are dear."""
    return frozenset(name for name in names if crc32(f"{drawn_by} {name}".encode()) % of)


def function_of(name: str) -> str:
    """The function of a test, without its parameters."""
    return name.partition("[")[0]

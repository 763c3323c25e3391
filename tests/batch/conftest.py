"""The class of four that several files compare with, made once."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.batch.homework import FOUR, made
from vecpoly.batch.classwork import Made


@pytest.fixture(scope="session")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Made]:
    """The folder of the class, and what was made; nobody writes into it."""
    out = tmp_path_factory.mktemp("whole") / "hw"
    return out, made(out, FOUR)

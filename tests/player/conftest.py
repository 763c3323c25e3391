"""One browser for all tests of the player that run in one process."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.chromium import Page, browser, chromium


@pytest.fixture(scope="session")
def chrome() -> Iterator[Page]:
    """A page of a headless Chromium; a test opens what it needs on it."""
    if browser() is None:
        pytest.skip("no chromium or chrome on this machine")
    with chromium() as opened:
        yield opened


@pytest.fixture(scope="session")
def boxes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the pages with a box for one's own answers: tests/player/boxes.py."""
    return tmp_path_factory.mktemp("boxes")

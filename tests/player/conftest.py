"""One browser for all tests of the player that run in one process."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.chromium import Page, browser, chromium


@pytest.fixture(scope="session")
def chrome() -> Iterator[Page]:
    """A page of a headless Chromium; a test opens what it needs on it."""
    if browser() is None:
        pytest.skip("no chromium or chrome on this machine")
    with chromium() as opened:
        yield opened

"""Problems and their pages, made once for all tests of the player, and what is asked of a page in a browser."""

from __future__ import annotations

import json
import re
from functools import cache
from typing import Any

from tests.chromium import Page
from vecpoly.player.page import player_html
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

PLACES = 6  # of the drive: as few as claims that are not about their number need
DESK, PHONE = (1440, 900), (390, 844)  # pixels


@cache
def solved(name: str) -> Solution:
    return solve(load(name), repeats=0)


@cache
def page_of(name: str, places: int = PLACES, lang: Lang = "zh") -> str:
    return player_html(solved(name), places=places, lang=lang)


def data(page: Page, script: str) -> Any:
    """What a script finds, as data."""
    return json.loads(page.value(f"JSON.stringify({script})"))


def motion(page: str) -> dict[str, Any]:
    """What a page knows of the places of the drive."""
    found = re.search(r'<script type="application/json" id="motion">(.*?)</script>', page, re.S)
    assert found is not None
    data: dict[str, Any] = json.loads(found[1])
    return data

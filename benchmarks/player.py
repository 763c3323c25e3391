"""The step player: bytes of the largest pages, and the time to first paint in headless Chromium."""

from __future__ import annotations

import time
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.chromium import browser, chromium
from vecpoly.player.page import player_html
from vecpoly.problem.load import load
from vecpoly.solution import solve

PROBLEMS = ("3-9", "4-3a", "A-27", "six-bar-dynamic", "C-inertia")
RUNS = 3


def run() -> str:
    """One line of the report."""
    parts = []
    with TemporaryDirectory() as folder:
        for name in PROBLEMS:
            solution, start = solve(load(name), repeats=0), time.process_time()
            page = player_html(solution)
            took, path = time.process_time() - start, Path(folder) / f"{name}.html"
            path.write_text(page, encoding="utf-8")
            paint = min(first_paint(path) for _ in range(RUNS)) if browser() else None
            shown = "no Chromium" if paint is None else f"{paint:.0f} ms"
            parts.append(f"{name} {len(page.encode()) / 1000:.0f} kB in {took:.1f} s, first paint {shown}")
    return f"step player: {'; '.join(parts)}; aims < 1000 kB, < 1000 ms"


def first_paint(path: Path) -> float:
    """First contentful paint (ms) of a page in a browser that has just started."""
    with chromium() as page:
        page.open(path.as_uri())
        return float(page.wait("performance.getEntriesByName('first-contentful-paint')[0]?.startTime"))


if __name__ == "__main__":
    print(run())

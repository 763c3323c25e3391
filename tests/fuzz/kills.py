"""kill -9 at a random moment of a run that writes:
afterwards outputs are whole or absent, inputs untouched, nothing else lies about."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vecpoly.foundation.data import data_dir

INPUT, KEPT = "in.yaml", b"what was there before"
RUNS = (
    ("report", INPUT, "-o", "out.pdf"),
    ("solve", INPUT, "--json", "out.json"),
    ("cycle", INPUT, "-n", "721", "-o", "out.xlsx"),
    ("play", INPUT, "--places", "6", "-o", "out.html"),
)
WHOLE = {".pdf": (b"%PDF", b"%%EOF\n"), ".json": (b"{", b"}\n"), ".xlsx": (b"PK", b""), ".html": (b"<!", b"</html>")}


@dataclass(frozen=True, slots=True)
class Kill:
    """What was wrong after a run was killed (empty: nothing), and whether it was killed before it ended."""

    wrong: str
    early: bool


def killed(rng: np.random.Generator, folder: Path, longest: float = 2.5) -> Kill:
    """Start a run in this folder, kill it after a random while, and look at what is there."""
    words = RUNS[int(rng.integers(len(RUNS)))]
    source = (data_dir("problems") / "homework" / "A-27.yaml").read_bytes()
    (folder / INPUT).write_bytes(source)
    old = bool(rng.integers(2))
    if old:
        (folder / words[-1]).write_bytes(KEPT)
    with subprocess.Popen(
        [sys.executable, "-m", "vecpoly", *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as run:
        time.sleep(float(rng.uniform(0.0, longest)))
        early = run.poll() is None
        run.kill()
    return Kill(_wrong(folder, words[-1], source, old), early)


def _wrong(folder: Path, name: str, source: bytes, old: bool) -> str:
    if (folder / INPUT).read_bytes() != source:
        return "the input was changed"
    strays = {path.name for path in folder.iterdir()} - {INPUT, name}
    if strays:
        return f"stray files: {', '.join(sorted(strays))}"
    out = folder / name
    if not out.exists():
        return "the old output is lost" if old else ""
    data = out.read_bytes()
    begins, ends = WHOLE[out.suffix]
    whole = data.startswith(begins) and data.rstrip().endswith(ends.rstrip())
    if whole and out.suffix == ".json":
        json.loads(data)
    return "" if whole or (old and data == KEPT) else f"{len(data)} bytes of {name}, not whole"

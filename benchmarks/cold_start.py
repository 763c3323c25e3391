"""`vecpoly solve 3-9` from a cold start: wall time of the process, of its imports, and what it must not import."""

from __future__ import annotations

import subprocess
import sys
import time

_PROBE = "import sys,time;t=time.perf_counter();import vecpoly.solution,vecpoly.problem.load;print(time.perf_counter()-t,'matplotlib' in sys.modules)"


def run() -> str:
    """One line of the report."""
    floor = min(_wall([sys.executable, "-c", "import numpy"]) for _ in range(5))
    whole = min(_wall([sys.executable, "-m", "vecpoly", "solve", "3-9", "--json", "-"]) for _ in range(5))
    probes = [subprocess.run([sys.executable, "-c", _PROBE], capture_output=True, text=True, check=True).stdout.split() for _ in range(5)]
    imports = min(float(p[0]) for p in probes)
    return (f"vecpoly solve 3-9, cold: {whole * 1e3:.0f} ms wall = {whole / floor:.2f} × python -c 'import numpy' ({floor * 1e3:.0f} ms); "
            f"imports {imports * 1e3:.0f} ms (aim < 400); matplotlib imported: {probes[0][1]}")


def _wall(command: list[str]) -> float:
    start = time.perf_counter()
    subprocess.run(command, capture_output=True, check=True)
    return time.perf_counter() - start

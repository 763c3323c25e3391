"""`vecpoly solve 3-9` from a cold start:
CPU time of the process, wall time of its imports, and what it must not import."""

from __future__ import annotations

import resource
import subprocess
import sys

_PROBE = (
    "import sys,time;t=time.process_time();import "
    "vecpoly.solution,vecpoly.problem.load;print(time.process_time()-t,'matplotlib' in sys.modules)"
)


def run() -> str:
    """One line of the report."""
    times = [
        (
            _cpu([sys.executable, "-c", "import numpy"]),
            _cpu([sys.executable, "-m", "vecpoly", "solve", "3-9", "--json", "-"]),
        )
        for _ in range(7)
    ]
    floor, whole = (min(column) for column in zip(*times, strict=True))
    probes = [
        subprocess.run([sys.executable, "-c", _PROBE], capture_output=True, text=True, check=True).stdout.split()
        for _ in range(5)
    ]
    imports = min(float(p[0]) for p in probes)
    return (
        f"vecpoly solve 3-9, cold: {whole * 1e3:.0f} ms CPU = {whole / floor:.2f} × python -c 'import numpy' "
        f"({floor * 1e3:.0f} ms), aim ≤ 3.5; imports {imports * 1e3:.0f} ms; matplotlib imported: {probes[0][1]}"
    )


def _cpu(command: list[str]) -> float:
    """CPU seconds of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


if __name__ == "__main__":
    print(run())

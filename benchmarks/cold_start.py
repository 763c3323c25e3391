"""`vecpoly solve 3-9` from a cold start: CPU time of the process, of its imports, and what it must not import.

Both it and numpy are compiled to bytecode beforehand, as they are from the second start on wherever Python may write.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from tempfile import TemporaryDirectory

_PROBE = (
    "import sys,time;t=time.process_time();import "
    "vecpoly.solution,vecpoly.problem.load;print(time.process_time()-t,'matplotlib' in sys.modules)"
)


def run() -> str:
    """One line of the report."""
    with TemporaryDirectory() as folder:
        env = {**os.environ, "PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        commands = (["-c", "import numpy"], ["-m", "vecpoly", "solve", "3-9", "--json", "-"])
        times = [[_cpu(command, env) for command in commands] for _ in range(8)][1:]  # the first compiles
        probes = [_output(["-c", _PROBE], env).split() for _ in range(5)]
    floor, whole = (min(column) for column in zip(*times, strict=True))
    imports = min(float(p[0]) for p in probes)
    return (
        f"vecpoly solve 3-9, cold: {whole * 1e3:.0f} ms CPU = {whole / floor:.2f} × python -c 'import numpy' "
        f"({floor * 1e3:.0f} ms), aim ≤ 3.5; imports {imports * 1e3:.0f} ms; matplotlib imported: {probes[0][1]}"
    )


def _cpu(command: list[str], env: dict[str, str]) -> float:
    """CPU seconds of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    _output(command, env)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def _output(command: list[str], env: dict[str, str]) -> str:
    return subprocess.run([sys.executable, *command], capture_output=True, text=True, check=True, env=env).stdout


if __name__ == "__main__":
    print(run())

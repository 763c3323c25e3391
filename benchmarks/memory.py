"""Peak memory of whole processes: numpy alone, one solved problem, the demo's two reports."""

from __future__ import annotations

import subprocess
import sys
from tempfile import TemporaryDirectory

_RUN = """
import atexit, sys
from pathlib import Path
def peak():
    status = Path("/proc/self/status").read_text()
    sys.stderr.write(next(line for line in status.splitlines() if line.startswith("VmHWM")).split()[1])
atexit.register(peak)
{work}
"""


def run() -> str:
    """One line of the report."""
    with TemporaryDirectory() as folder:
        floor = _mib("import numpy")
        solve = _mib("import vecpoly; vecpoly.load('3-9').solve()")
        demo = _mib(
            f"import sys; sys.argv = ['vecpoly', 'demo', '-o', {folder!r}]; from vecpoly.__main__ import main; main()"
        )
    return (
        f"peak memory: solve 3-9 {solve:.0f} MiB = {solve / floor:.2f} × import numpy ({floor:.0f} MiB); "
        f"demo, two reports of 20 problems, {demo:.0f} MiB = {demo / floor:.2f} ×"
    )


def _mib(work: str) -> float:
    """Peak resident memory of a Python process that does this work (Linux: VmHWM, in KiB)."""
    code = _RUN.format(work=work)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stderr.split()[-1].strip()) / 1024

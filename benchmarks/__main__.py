"""Run all benchmarks together: `python -m benchmarks`."""

from __future__ import annotations

from . import cold_start, memory, oracle_forces, oracle_sixbar, pencil_hands, report_pages

if __name__ == "__main__":
    for module in (oracle_sixbar, oracle_forces, pencil_hands, report_pages, cold_start, memory):
        print(module.run(), flush=True)

"""Run all benchmarks together: `python -m benchmarks`."""

from __future__ import annotations

from . import (
    chains,
    class_sheets,
    cold_start,
    course_report,
    cycle,
    lettering,
    machine,
    memory,
    oracle_forces,
    oracle_sixbar,
    pencil_hands,
    player,
    printed_tables,
    redraw,
    report_pages,
    search,
)

if __name__ == "__main__":
    for module in (
        oracle_sixbar,
        cycle,
        oracle_forces,
        machine,
        pencil_hands,
        report_pages,
        lettering,
        chains,
        redraw,
        printed_tables,
        player,
        cold_start,
        course_report,
        class_sheets,
        memory,
        search,
    ):
        print(module.run(), flush=True)

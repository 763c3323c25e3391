"""Chapter 7, the answers printed in the book beside the exact ones, and what the book itself has wrong."""

from __future__ import annotations

from typing import Any

from ....check.printed.answers import check_problem
from ....findings.study.study import Study
from ....words import Words
from ...tables import printed_table
from ...verdicts import judged_by, verdicts
from ..numbering import SMALL, Press


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The table of printed answers with a verdict on each, and what is said of them;
    empty where the book gives none."""
    checked = check_problem(study.given.problem)
    made = printed_table(checked.answers, press.lang) if checked.answers else None
    table = (
        press.table(
            Words("书中数据与精确值", "Printed and exact values"), made.header, made.rows, made.align, style=SMALL
        )
        if made
        else ""
    )
    return {"table": table, "verdicts": verdicts(study.given, checked, press.lang)} | judged_by(checked.answers)

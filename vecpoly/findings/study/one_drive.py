"""A course report follows one drive: of several, which of them would move on is not told."""

from __future__ import annotations

from ...errors import NotAskedError
from ...problem.problem import Problem
from ...words import Words


def follows_one_drive(problem: Problem) -> None:
    """Raises NotAskedError where several links are driven."""
    if len(drives := problem.mechanism.drives) > 1:
        links = ", ".join(drive.link for drive in drives)
        raise NotAskedError(
            Words(
                f"课程报告只随一个原动件走完运动循环，而题目 {problem.id} 有 {len(drives)} 个（构件 "
                f"{links.replace(', ', '、')}）；请改写解答报告（--style solution），或只留一个原动件",
                f"a course report follows one drive through its cycle, and problem {problem.id} has "
                f"{len(drives)} (links {links}); write its solution report (--style solution), or keep one drive",
            )
        )

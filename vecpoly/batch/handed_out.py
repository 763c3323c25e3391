"""What was handed out stays: the register of an earlier run into the same folder."""

from __future__ import annotations

from pathlib import Path

from ..errors import VecpolyError
from ..grading.scheme import USUAL_SCHEME
from ..problem.assignment import Assignment
from ..words import Words
from .register import NAME, Exercise, Part, Register, read_register


def handed_out(out: Path, assignment: Assignment) -> Register | None:
    """The register of an earlier run into this folder. Raises VecpolyError where it is of another assignment."""
    if not (out / NAME).exists():
        return None
    old = read_register(out)
    if (old.assignment, old.salt) != (assignment.id, assignment.salt):
        raise VecpolyError(
            Words(
                f"{out / NAME} 属于作业 {old.assignment}，而不是 {assignment.id}；请另取 -o 文件夹",
                f"{out / NAME} is of assignment {old.assignment}, not {assignment.id}; name another folder with -o",
            ),
            code="other-class",
        )
    return old


def unchanged(now: Exercise, old: Register | None, out: Path) -> Exercise:
    """The problem. Raises VecpolyError where it was changed after its sheets were made: all would have other values."""
    before = None if old is None else next((one for one in old.exercises if one.id == now.id), None)
    if before is None or not (keys := before.changed(now)):
        return now
    raise VecpolyError(
        Words(
            f"题 {now.id} 在发题之后改动过（{'、'.join(keys)}），各人的数据将与 {out / NAME} 中已发的不同；"
            f"请改回原样，或另取 -o 文件夹；若题单确未发出，可删去该文件夹",
            f"problem {now.id} was changed ({', '.join(keys)}) after its sheets were made: everybody would have other "
            f"values than those in {out / NAME}; change it back, or name another folder with -o; if no sheet was "
            "handed out, delete that folder",
        ),
        code="changed",
        numbers={"problem": now.id},
    )


def kept(old: Register | None, problem: str) -> dict[str, Part]:
    """Who has values of this very problem already."""
    if old is None:
        return {}
    usual = old.marked_by(USUAL_SCHEME)  # pages do not follow from points
    return {sheet.student.number: part for sheet in usual.sheets for part in sheet.parts if part.problem == problem}

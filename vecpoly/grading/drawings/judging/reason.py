"""Why a vector is not right, in a sentence: from what was measured, the textbook's words for it."""

from __future__ import annotations

from ....words import Words
from ..expected import Edge
from .mark import Basis, VectorMark, Verdict

FAIR = (Verdict.RIGHT, Verdict.CLOSE)


def reason(mark: VectorMark, edge: Edge, scale: float) -> Words:
    """What is wrong with a vector, or how well it is drawn; lengths in mm of the sheet."""
    own = _on_own(mark)
    if mark.sense is None:
        return Words("没有箭头，指向无从判断", "it has no arrow head; its sense cannot be told") + own
    if not mark.sense:
        return _reversed(mark, edge, scale)
    if mark.verdict is Verdict.RIGHT:
        e, t = abs(mark.off) * scale, mark.allowed * scale
        zh, en = f"误差 {e:.2f} mm，允许 ±{t:.2f} mm", f"off by {e:.2f} mm, allowed ±{t:.2f} mm"
        return Words(f"正确（{zh}）", f"correct ({en})") + own
    if mark.direction not in FAIR and mark.length in FAIR:
        d = mark.turned
        return Words(f"长度可以，但方向差 {_signed(d)}", f"length fine, direction off by {_signed(d)}") + own
    return _length(mark, scale) + own


def _on_own(mark: VectorMark) -> Words:
    if mark.basis is Basis.EXACT:
        return Words("", "")
    return Words("；按自己前面的图线衡量，不重复扣分", "; held against the own lines before it, not penalised again")


def _reversed(mark: VectorMark, edge: Edge, scale: float) -> Words:
    tail, tip = (letters[0] if letters else "?" for letters in (edge.tail, edge.tip))
    if mark.length in FAIR and mark.direction in FAIR:
        return Words(
            f"大小正确，指向相反：箭头应由 {tail} 指向 {tip}",
            f"magnitude right, sense reversed: the arrow runs from {tail} to {tip}",
        )
    return Words("指向相反；", "sense reversed; ") + _length(mark, scale)


def _length(mark: VectorMark, scale: float) -> Words:
    own, should = abs(mark.own or 0j) * scale, abs(mark.should) * scale
    near = mark.verdict is Verdict.CLOSE
    zh, en = ("接近：", "close: ") if near else ("", "")
    lean = "" if mark.direction in FAIR else f"，方向差 {_signed(mark.turned)}"
    leans = "" if mark.direction in FAIR else f", direction off by {_signed(mark.turned)}"
    allowed = mark.allowed * scale
    return Words(
        f"{zh}长 {own:.2f} mm，应为 {should:.2f} mm（允许 ±{allowed:.2f} mm）{lean}",
        f"{en}{own:.2f} mm long, should be {should:.2f} mm (allowed ±{allowed:.2f} mm){leans}",
    )


def _signed(degrees: float) -> str:
    return f"{degrees:+.1f}°".replace("-", "−")

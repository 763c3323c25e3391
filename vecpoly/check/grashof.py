"""Of what type a four-bar linkage is, by its lengths alone."""

from __future__ import annotations

from ..words import Words

CRANK_ROCKER = Words("曲柄摇杆机构", "crank-rocker")
DRIVEN_BY_ROCKER = CRANK_ROCKER + Words("（$CD$ 为曲柄）", " ($CD$ the crank)")
DOUBLE_CRANK, DOUBLE_ROCKER = Words("双曲柄机构", "double crank"), Words("双摇杆机构", "double rocker")
ROUNDING = 1e-12  # of the longest: sums of lengths that differ by less are equal
PARALLELOGRAM = Words("平行四边形机构（或反平行四边形机构）", "parallelogram or antiparallelogram linkage")
NOT_GRASHOF = Words("双摇杆机构（不满足杆长条件）", "triple rocker (not Grashof)")


def grashof(ab: float, bc: float, cd: float, ad: float) -> tuple[Words, float]:
    """The type with AB as the input and AD as the frame, and the margin p + q − l_min − l_max of the sum of lengths.

    Where two links are the shortest, what turns right round about the frame tells: of a kite with a short frame both.
    """
    least, *middle, most = sorted((ab, bc, cd, ad))
    margin = sum(middle) - least - most
    margin = 0.0 if abs(margin) < ROUNDING * most else margin
    if margin < 0:
        return NOT_GRASHOF, margin
    near = ROUNDING * most
    if abs(ab - cd) <= near and abs(bc - ad) <= near:
        return PARALLELOGRAM, margin
    kinds = ((ad, DOUBLE_CRANK), (ab, CRANK_ROCKER), (cd, DRIVEN_BY_ROCKER), (bc, DOUBLE_ROCKER))
    return next(kind for length, kind in kinds if length - least <= near), margin

"""What is said of the tip of a tooth: pointed, too thin, thick enough, or not to be told from the drawing."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import number
from ....board.hand import scatter
from ....plane import Reals
from ....plane.traced import bare
from ....words import Words

THIN = 0.25  # modules: a tip that is thinner breaks


def pointed(tip: Reals, module: float) -> Words:
    """Whether the tip (mm) is thick enough for its module, as far as the hands that read it agree."""
    modules = np.atleast_1d(bare(tip)) / module
    size, off = float(modules[0]), 3 * scatter(modules)
    limit = f"${THIN:g}·m$ = {number(THIN * module)} mm"
    if abs(size - THIN) < off:
        found, told = ("小于", "less") if size < THIN else ("大于", "more")
        return Words(
            f"量得值{found} {limit}，但两者之差小于读数误差，齿顶是否过薄不能由图判定，应以计算校核。",
            f" As read it is {told} than {limit}, but by less than the reading error: whether the tip is too thin "
            "cannot be told from the drawing, and is to be computed.",
        )
    if size <= 0:
        return Words(
            "两侧齿廓在齿顶圆以内相交，齿顶变尖，$s_a$ = 0：应减小变位系数 $x$ 或齿顶高系数。",
            " The flanks meet inside the tip circle: the tooth is pointed, $s_a$ = 0. Take a smaller shift $x$, or a "
            "smaller addendum.",
        )
    if size < THIN:
        return Words(f"小于 {limit}，齿顶过薄。", f" It is less than {limit}: the tip is too thin.")
    return Words(f"不小于 {limit}，足够厚。", f" It is not less than {limit}: the tip is thick enough.")

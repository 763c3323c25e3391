"""Why a problem has no variants: too few draws pass, or nothing that is asked can be drawn well enough."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import median

from ..errors import VecpolyError
from ..problem.problem import Problem
from ..words import Words
from .conditions import Condition
from .judge import deviation, long_enough
from .look import Look

LEAST = 0.01  # yield below which the ranges are refused


def too_few(name: str, passed: float, failed: Mapping[Condition, float]) -> VecpolyError:
    worst = max(failed, key=lambda one: failed[one], default=Condition.REFUSED)
    share = failed.get(worst, 0.0)
    return VecpolyError(
        Words(
            f"题 {name}：随机取值中只有 {100 * passed:.1f} % 合格（至少要 {100 * LEAST:g} %），"
            f"最常见的原因是{worst.words.zh}（{100 * share:.0f} %）；请{worst.remedy.zh}",
            f"problem {name}: only {100 * passed:.1f} % of the draws pass (at least {100 * LEAST:g} % must); "
            f"most fail because of this: {worst.words.en} ({100 * share:.0f} %); {worst.remedy.en}",
        ),
        code="low-yield",
        numbers={"yield": passed, "condition": str(worst), "failed": share},
    )


def nothing_left(problem: Problem, looks: Sequence[Look]) -> VecpolyError:
    """Everything that is asked is too short in most drawings, or drawn too badly: told with what each scatters by."""
    asked = dict.fromkeys(one.key for look in looks for one in look.asked)
    sizes = {key: median(deviation(one) for look in looks if (one := look.key.find(key)) is not None) for key in asked}
    short = sum(not long_enough(one, look) for look in looks for one in look.asked)
    badly = sum(deviation(one) > problem.gate.deviation for look in looks for one in look.asked)
    condition = Condition.VECTORS if short >= badly else Condition.DEVIATION
    told = ", ".join(f"{key} {100 * size:.0f} %" for key, size in sizes.items())
    most = 100 * problem.gate.deviation
    return VecpolyError(
        Words(
            f"题 {problem.id}：没有可评分的量：{condition.words.zh}；作图的离散（2σ，最大 {most:g} %）为 {told}；"
            f"请{condition.remedy.zh}，或取较大的尺寸，使图按较大的比例绘制",
            f"problem {problem.id}: nothing that is asked can be graded: {condition.words.en}; drawings scatter by "
            f"2σ (at most {most:g} %) = {told}; {condition.remedy.en}, or make it larger, so that it is drawn larger",
        ),
        code="low-yield",
        numbers={"yield": 0.0, "condition": str(condition), **sizes},
    )

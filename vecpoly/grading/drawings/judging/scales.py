"""What is said of a polygon whose scale is not stated, or is not the one that is."""

from __future__ import annotations

from ....words import Words

OTHER_SCALE = Words(
    "没有按写明的比例尺画：或是写错了，或是另取了比例尺；请核对",
    "it is not drawn to the scale that is stated: wrongly stated, or another was taken; check it",
)
OTHER_SIZE = Words(
    "整幅图的大小与所写的比例尺不符：或是缩放输出，或是整幅图另取了比例尺；请核对",
    "the whole sheet is of another size than its scales say: put out so, or drawn to other scales throughout; check it",
)


def undeclared(mu: float, symbol: str) -> Words:
    """Of a scale that nobody stated; mu: SI per mm, as the known vector has it."""
    return Words(
        f"没有写比例尺 ${symbol}$；由已知矢量推得 {mu:.4g}：或是另取了比例尺，或是已知矢量画错",
        f"${symbol}$ is not stated; by the known vector it is {mu:.4g}: another scale, or the known vector is wrong",
    )


def other_scale(mu: float, symbol: str) -> Words:
    """Of a polygon at another scale than the one that is stated."""
    return Words(
        f"这个多边形没有按写明的比例尺 ${symbol}$ 画：全部矢量一致按 {mu:.4g} 画成",
        f"this polygon is not drawn to the stated ${symbol}$: all its vectors agree in {mu:.4g}",
    )

"""Why three pairs of angles give no four-bar: said alike by drawing and oracle."""

from __future__ import annotations

from math import isfinite

from ...errors import AssemblyError, FaultError
from ...words import Words

NONE, FAR = 1e-6, 1e4  # of the frame: a link shorter, or longer, than that is none


def unbounded(letters: str, length: float) -> AssemblyError:
    """A link of no length, or of any; length: in frames."""
    if not isfinite(length):
        return AssemblyError(
            Words(
                f"按这三组对应角，{letters} 为无穷长，得不到铰链四杆机构；请改动角度或初始角",
                f"with these three pairs {letters} becomes infinitely long: no four-bar; change the angles, or those "
                "at which they begin",
            ),
            code="no-solution",
        )
    size = f"{abs(length):.3g}"
    return AssemblyError(
        Words(
            f"按这三组对应角，{letters} 的长度为机架的 {size} 倍，得不到铰链四杆机构；请改动角度或初始角",
            f"with these three pairs {letters} becomes {size} times as long as the frame: no four-bar; change the "
            "angles, or those at which they begin",
        ),
        code="no-solution",
        numbers={"length": length},
    )


def turns_alike() -> FaultError:
    """ψ = φ in all positions."""
    return FaultError(
        Words(
            "各组中 ψ = φ，两连架杆同步转动：任何平行四边形机构（AB = CD，BC = AD）都满足，没有什么可求；请改动角度",
            "ψ = φ in every pair, both links turn alike: any parallelogram does that (AB = CD, BC = AD), and nothing "
            "is left to be found; change the angles",
        ),
        code="contradiction",
    )


def checked(letters: str, length: float) -> float:
    """The length in frames; raises AssemblyError where it is none."""
    if not NONE < abs(length) < FAR:
        raise unbounded(letters, length)
    return length

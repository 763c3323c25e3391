"""What drives a machine and what it overcomes over a period: moments, powers, or areas that are known already."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import degrees

from ...errors import FaultError
from ...units.reading import Quantity
from ...words import Words
from .curve import SAME, Curve
from .lobes import levels, works

BALANCED = 1e-6  # of the work of a period: by how much driving and resisting work may differ
CLOSED = 0.01  # of all areas together: what may be misread of areas that are given


@dataclass(frozen=True, kw_only=True)
class Torques:
    """M_d and M_r over a period (rad); `sought`: the one that is constant and follows from the other, d or r."""

    driving: Curve
    resisting: Curve
    period: float
    sought: str = ""

    @cached_property
    def works(self) -> tuple[float, ...]:
        """About how much lies between one meeting and the next (J)."""
        return works(self.driving, self.resisting, self.period)

    @property
    def count(self) -> int:
        """How many areas lie between the curves."""
        return len(self.works)

    @property
    def highest(self) -> tuple[float, float]:
        """The least and the greatest moment, and 0 between them."""
        spans = self.driving.span, self.resisting.span
        return min(0.0, *(low for low, _ in spans)), max(0.0, *(high for _, high in spans))

    @property
    def swing(self) -> float:
        """About how much the energy changes."""
        at_each = levels(self.works)
        return max(at_each) - min(at_each)


@dataclass(frozen=True, kw_only=True)
class Areas:
    """Areas (mm²) between the curves, positive where they are a surplus, and their scale (J/mm²)."""

    sizes: tuple[float, ...]
    scale: float

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.sizes)

    @property
    def swing(self) -> float:
        """About how much the energy changes (J)."""
        at_each = levels(self.sizes)
        return self.scale * (max(at_each) - min(at_each))


def torques(driving: Curve | None, resisting: Curve | None, period: Quantity | None) -> Torques:
    """Both curves over their period; raises FaultError where they do not fit each other, with both numbers."""
    span = _period([one for one in (driving, resisting) if one is not None and not one.constant], period)
    given = driving or resisting
    assert given is not None
    if driving is None or resisting is None:
        mean = sum(works(given, _flat(0.0), span)) / span
        return Torques(
            driving=driving or _flat(mean),
            resisting=resisting or _flat(mean),
            period=span,
            sought="d" if driving is None else "r",
        )
    both = Torques(driving=driving, resisting=resisting, period=span)
    _balance(both)
    return both


def of_powers(rows: Sequence[tuple[Quantity, Quantity]], omega: float) -> Torques:
    """Constant powers (W), each over an angle, at a constant speed: P = M ω; the motor's moment is the same always."""
    places: list[float] = []
    sizes: list[float] = []
    at = 0.0
    for angle, power in rows:
        places += [at, at := at + angle.si]
        sizes += [power.si / omega] * 2
    text = ", ".join(f"{angle.text}: {power.text}" for angle, power in rows)
    return torques(None, Curve(places=tuple(places), sizes=tuple(sizes), text=text), None)


def areas(sizes: tuple[float, ...], scale: float) -> Areas:
    """The areas; raises FaultError where surpluses and deficits differ by more than is misread."""
    left, whole = sum(sizes), sum(map(abs, sizes))
    if len(sizes) < 2 or not whole:
        raise FaultError(
            Words("至少要有两块面积，如 [320, -320]", "two areas at least are needed, e.g. [320, -320]"),
            "areas",
            code="missing",
        )
    if abs(left) > CLOSED * whole:
        raise _unsteady(left * scale, f"{left:+g} mm²")
    return Areas(sizes=sizes, scale=scale)


def _flat(value: float) -> Curve:
    return Curve(places=(0.0,), sizes=(value,), text="")


def _period(curves: Sequence[Curve], period: Quantity | None) -> float:
    """That of the curves, or as given; raises FaultError where they differ, or are constant."""
    ends = [curve.end for curve in curves]
    if period is not None and ends and abs(ends[0] - period.si) > SAME:
        raise _differing("period", degrees(period.si), degrees(ends[0]))
    if len(ends) == 2 and abs(ends[0] - ends[1]) > SAME:
        raise _differing("M_r", degrees(ends[1]), degrees(ends[0]))
    if not ends:
        raise FaultError(
            Words(
                "M_d 和 M_r 都是常数，没有速度波动；至少一个应为转角的函数，如 [[0 deg, 0 N*m], [180 deg, 90 N*m]]",
                "M_d and M_r are both constant and the speed does not vary; one of them must change with the angle, "
                "e.g. [[0 deg, 0 N*m], [180 deg, 90 N*m]]",
            ),
            code="contradiction",
            keys=("M_d", "M_r"),
        )
    return ends[0]


def _differing(key: str, one: float, other: float) -> FaultError:
    return FaultError(
        Words(
            f"{key} 的周期为 {one:g}°，而曲线终止于 {other:g}°；两者应相同",
            f"{key} has a period of {one:g} deg and the curve ends at {other:g} deg; they must be one",
        ),
        key,
        code="contradiction",
        numbers={"period": one, "end": other},
    )


def _balance(both: Torques) -> None:
    """FaultError where the machine gains or loses energy in a period."""
    left = sum(both.works)
    whole = max(abs(sum(works(one, _flat(0.0), both.period))) for one in (both.driving, both.resisting))
    if abs(left) > BALANCED * max(whole, max(map(abs, both.works))):
        raise _unsteady(left, "")


def _unsteady(left: float, on_paper: str) -> FaultError:
    told = f"（{on_paper}）" if on_paper else ""
    remedy = Words(
        "请改正数据，或删去 M_d、M_r 之一，由面积相等求出常数力矩",
        "mend the data, or leave out M_d or M_r, which then is the constant of equal area",
    )
    return FaultError(
        Words(
            f"一个周期内驱动功与阻力功不相等：每周期动能变化 {left:+.6g} J{told}，机器不能稳定运转，δ 和飞轮都无意义；",
            f"driving and resisting work differ over a period: the energy changes by {left:+.6g} J"
            f"{f' ({on_paper})' if on_paper else ''} in each, so that the motion is not steady and neither delta nor a "
            "flywheel means anything; ",
        )
        + (Words("请使各面积之和为零", "mend the areas, whose sum is zero") if on_paper else remedy),
        code="unsteady",
        numbers={"dW": left},
        keys=("M_d", "M_r", "areas", "powers"),
    )

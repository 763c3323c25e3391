"""The scales to which is drawn, as written."""

from __future__ import annotations

from ...errors import FaultError
from ...figures import Mu, scales
from ...figures.mu import LENGTH
from ...limits import PAPER
from ...mechanism.model import Mechanism
from ...units.names import plain, unit_of
from ...units.reading import PerMm, read
from ...words import Words
from ..problem import Scales
from ..schema.models import ScalesSpec


def read_scales(spec: ScalesSpec) -> Scales:
    """Given scales; those that are auto are left out."""
    written = {key: (mu, getattr(spec, key, "auto")) for key, mu in scales().items()}
    return Scales({key: _scale(mu, text) for key, (mu, text) in written.items() if text not in ("auto", "自动")})


def _scale(mu: Mu, text: str) -> float:
    try:
        value = read(text, PerMm(mu.called, mu.unit, mu.example)).si / unit_of(plain(mu.unit))[0]
    except FaultError as fault:
        raise fault.under(mu.key) from None
    if value <= 0:
        raise FaultError(
            Words(
                f"“{text}”应大于零；如写 {mu.example} 或 auto",
                f"'{text}' must be greater than zero; write e.g. {mu.example} or auto",
            ),
            mu.key,
            code="out-of-range",
        )
    return value


def plottable(given: Scales, mech: Mechanism) -> None:
    """Raise FaultError where the mechanism would be a speck, or far larger than any paper."""
    per_mm = given.of(LENGTH)
    if per_mm is None:
        return
    size, (least, most) = mech.scale / per_mm, PAPER
    if not least <= size <= most:
        told = f"{size:.3g} mm"
        raise FaultError(
            Words(
                f"按此比例尺，机构在图纸上的尺寸为 {told}，无法作图（应在 {least:g} 至 {most:g} mm 之间）；"
                "请核对或写 auto",
                f"at this scale the mechanism would measure {told} on paper, which cannot be "
                f"drawn ({least:g} to {most:g} mm can); check it, or write auto",
            ),
            "mu_l",
        )

"""Numbers with a comma where a decimal point belongs."""

from __future__ import annotations

from ..errors import FaultError
from ..foundation.patterns import pattern
from ..words import Words

_COMMA = pattern(r"\s*([+\-−]?\d+)[,，](\d+)")


def refuse_comma(text: str) -> None:
    """Raise FaultError for a number with a comma in it, 50,5 mm: with three digits behind it is a fraction here and
    thousands there."""
    m = _COMMA.match(text)
    if m is None:
        return
    point, whole = f"{m[1]}.{m[2]}{text[m.end() :]}", f"{m[1]}{m[2]}{text[m.end() :]}"
    thousands = (
        Words(f"，若是千位分隔则写 {whole}", f", or {whole} if it parts thousands") if len(m[2]) == 3 else Words("", "")
    )
    raise FaultError(
        Words(
            f"“{text}”中有逗号，小数点应写成句点；请写 {point}",
            f"'{text}' has a comma in its number, where a decimal point belongs; write {point}",
        )
        + thousands,
        code="decimal-comma",
        numbers={"written": text},
    )

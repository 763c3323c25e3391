"""Letters with an index of their own: O₁, O₂, as many books call the fixed pivots. Each is one letter here; a figure on
the line says on which link a point is thought, B3."""

from __future__ import annotations

DIGITS = "₀₁₂₃₄₅₆₇₈₉"
LETTER = rf"[A-Z][a-z'′{DIGITS}]?"  # of a point: C, E', Oa, O₁
ON_LINE = str.maketrans(DIGITS, "0123456789")
BELOW = str.maketrans("0123456789", DIGITS)

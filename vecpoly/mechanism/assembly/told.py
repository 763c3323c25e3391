"""The assemblies of a group, told so that one of them can be chosen: as guesses of two points."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ...words import Words

NAMED = 6  # assemblies told in a refusal


def as_guesses(found: Sequence[Mapping[str, complex]], letters: Iterable[str], mm: float) -> str:
    """{B: [10 mm, 20 mm], C: [30 mm, 40 mm]}; …: the first few of them. mm: of a unit of these places."""
    points = tuple(letters)
    told = "; ".join(
        "{" + ", ".join(f"{p}: [{at[p].real * mm:.4g} mm, {at[p].imag * mm:.4g} mm]" for p in points) + "}"
        for at in found[:NAMED]
    )
    return told + "; …" if len(found) > NAMED else told


def which(links: Words, count: int, guesses: str) -> Words:
    """That there are so many, and one must be chosen."""
    return Words(
        f"构件 {links.zh} 有 {count} 种装配，须说明取哪一种：写 guesses: 下列之一（约数即可），"
        f"或用 branch 说明：{guesses}",
        f"links {links.en} can be joined in {count} ways; say which by `branch`, or by `guesses:`, "
        f"one of these (roughly): {guesses}",
    )

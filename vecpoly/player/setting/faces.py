"""Fonts inside the page: of each face just the characters that the page uses,
so that it looks alike everywhere and loads nothing."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping
from functools import lru_cache
from io import BytesIO

from fontTools import subset
from fontTools.ttLib import TTFont

from ...typeset.fonts import Face, path
from .type import short

SLANTED = {Face.ITALIC, Face.BOLD_ITALIC}
HEAVY = {Face.BOLD, Face.BOLD_ITALIC, Face.HEI_BOLD}


def font_css(used: Mapping[Face, set[str]]) -> str:
    """An @font-face rule for each face in use, the font in it as a data URL; and the class that sets type in it."""
    return "\n".join(
        f"@font-face{{font-family:{family(face)};"
        f'src:url(data:font/woff;base64,{_woff(face, "".join(sorted(chars)))}) format("woff")}}\n'
        f".{short(face)}{{font-family:{family(face)}}}"
        for face, chars in sorted(used.items())
    )


def family(face: Face) -> str:
    """The name of a face on the page: no font of the reader's machine has it."""
    return f"vp-{face.value.lower()}"


@lru_cache(maxsize=64)
def _woff(face: Face, chars: str) -> str:
    """A font of these characters alone, without hints and features, in base 64."""
    options = subset.Options(
        flavor="woff",
        hinting=False,
        layout_features=[],
        name_IDs=[],
        notdef_outline=False,
        glyph_names=False,
        legacy_kern=False,
        drop_tables=["GSUB", "GPOS", "GDEF", "kern", "DSIG", "FFTM", "MATH", "vhea", "vmtx", "gasp", "BASE", "STAT"],
    )
    font = TTFont(path(face), lazy=True, recalcTimestamp=False)
    tool = subset.Subsetter(options)
    tool.populate(text=chars)
    tool.subset(font)
    data = BytesIO()
    font.flavor = "woff"
    font.save(data)
    return b64encode(data.getvalue()).decode()

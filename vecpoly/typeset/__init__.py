"""Type: the faces, formulas laid out as text, and drawing of what was laid out."""

from __future__ import annotations

from .box import Box, Glyphs, Rule
from .canvas import draw
from .layout import layout
from .svg import svg_group
from .words import layout_words

__all__ = ["Box", "Glyphs", "Rule", "draw", "layout", "layout_words", "svg_group"]

"""Tasks of synthesis, cams, trains and generated gears: random data for every kind, third parties that move what was
found by formulas of their own."""

from . import angles, bodies, cams, cranks, paths, strokes, wheels

__all__ = ["angles", "bodies", "cams", "cranks", "paths", "strokes", "wheels"]

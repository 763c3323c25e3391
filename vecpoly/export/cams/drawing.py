"""A profile as DXF: a spline for each stretch, its points, the base circle's centre, and the tolerance in words."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import numpy as np

from ...methods.devices.cam.trying import Traced
from ..dxf.document import MILLIMETRES, VERSION, library
from .profile import Profile

if TYPE_CHECKING:
    from ezdxf.math import BSpline

CLOSED, FINE = 1e-6, 8  # mm: ends nearer than this are one; samples between two points


def cam_dxf(profile: Profile) -> bytes:
    """True to size in mm, the cam's axis at the origin."""
    doc = library().new(VERSION, units=MILLIMETRES)
    for name, colour in (("profile", 7), ("points", 8), ("axis", 4), ("text", 7)):
        doc.layers.add(name, color=colour)
    space = doc.modelspace()
    splines = [_spline(part) for part in profile.stretches]
    for spline in splines:
        space.add_spline(dxfattribs={"layer": "profile"}).apply_construction_tool(spline)
    ends = [(part.edge[0], part.edge[-1]) for part in profile.stretches]
    for (_, before), (after, _) in zip(ends, [*ends[1:], ends[0]], strict=True):
        if abs(after - before) > CLOSED:  # the face lies on a flat of the cam where the velocity jumps
            space.add_line((before.real, before.imag), (after.real, after.imag), {"layer": "profile"})
    every = np.concatenate([part.edge for part in profile.stretches])
    for spot in every[np.abs(every - np.roll(every, 1)) > CLOSED]:  # where two stretches meet, one
        space.add_point((spot.real, spot.imag), {"layer": "points"})
    space.add_circle((0, 0), 1.0, {"layer": "axis"})
    told = f"mm; the splines leave the profile by {tolerance(profile):.6f} mm at most"
    space.add_text(told, height=2.5, dxfattribs={"layer": "text"}).set_placement((2, 2))
    text = io.StringIO()
    doc.write(text)
    return text.getvalue().encode()


def tolerance(profile: Profile) -> float:
    """By how much a spline passes a point that it was not led through, at most (mm)."""
    return max(_off(_spline(part), part, fine) for part, fine in zip(profile.stretches, profile.between, strict=True))


def _spline(part: Traced) -> BSpline:
    from ezdxf.math import global_bspline_interpolation

    degree = min(3, len(part.edge) - 1)
    return global_bspline_interpolation([(spot.real, spot.imag) for spot in part.edge], degree=degree)


def _off(spline: BSpline, part: Traced, fine: Traced) -> float:
    samples = np.linspace(0.0, spline.max_t, FINE * len(part.edge) + 1)
    line = np.array([complex(p.x, p.y) for p in spline.points(samples.tolist())])
    a, b = line[:-1], line[1:]
    along = np.where(np.abs(b - a) > 0, b - a, 1.0)
    spots = fine.edge[1::2, None]
    share = np.clip(((spots - a) / along).real, 0.0, 1.0)
    return float(np.abs(spots - a - share * along).min(axis=1).max())

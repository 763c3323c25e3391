"""The points of a profile as CSV."""

from __future__ import annotations

import csv
import io
from math import degrees

from .profile import Profile

HEAD = ("phi_deg", "x_mm", "y_mm", "x_pitch_mm", "y_pitch_mm")


def cam_csv(profile: Profile) -> bytes:
    """A line a point, in the cam's plane with its first station upwards; before them the tolerance of the chords."""
    text = io.StringIO()
    text.write(f"# chords between neighbouring points leave the profile by {profile.chords:.4f} mm at most\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEAD)
    last = ""
    for part in profile.stretches:
        for phi, edge, pitch in zip(part.phi, part.edge, part.pitch, strict=True):
            row = [f"{value:.6f}" for value in (degrees(phi), edge.real, edge.imag, pitch.real, pitch.imag)]
            if "".join(row) != last:  # where two stretches join the point stands once
                writer.writerow(row)
            last = "".join(row)
    return text.getvalue().encode()

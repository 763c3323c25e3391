"""A plate cam: from the motion of its follower to the profile, with its pressure angles and its curvature."""

from __future__ import annotations

from ....devices.cams.cam import Cam
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from .curvature import least_radius
from .diagram import displacement
from .inversion import invert
from .least import least_circle
from .pressure import pressure_angles
from .scales import cam_scales


@device_method(
    Cam,
    title=Words("盘形凸轮廓线的设计（反转法）", "Design of a plate cam by inversion"),
    source="机械原理, cams: displacement diagrams, inversion, envelope, pressure angle, Hartmann's construction",
    example="cam-roller-offset",
    scales=cam_scales,
    called=Words("凸轮廓线", "Profile of the cam"),
)
def draw_cam(bench: Bench, cam: Cam) -> None:
    """The displacement diagram, the cam, its pressure angles and its curvature; or the least base circle."""
    if cam.alpha is not None:
        least_circle(bench, cam)
        return
    cuts = invert(bench, cam, displacement(bench, cam))
    if not cam.follower.flat:
        pressure_angles(bench, cam, cuts)
    least_radius(bench, cam, cuts)

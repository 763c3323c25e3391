"""Keys of the problem file that no other family writes: each with a judge of its own."""

from . import (
    aliases,
    asked,
    designs,
    devices,
    loads,
    motions,
    places,
    resting,
    scaled,
    stages,
    stages_limited,
    swinging,
    taken,
    two_drives,
)

__all__ = [
    "aliases",
    "asked",
    "designs",
    "devices",
    "loads",
    "motions",
    "places",
    "resting",
    "scaled",
    "stages",
    "stages_limited",
    "swinging",
    "taken",
    "two_drives",
]

"""Keys of the problem file that no other family writes: each with a judge of its own."""

from . import aliases, designs, devices, loads, motions, places, stages, stages_limited, swinging, taken

__all__ = ["aliases", "designs", "devices", "loads", "motions", "places", "stages", "stages_limited", "swinging", "taken"]

"""Gears that roll: pitch points, racks, trains, and groups with a gear as a link."""

"""A ring-spring buffer: its polygons, and the limits of self-locking."""

"""Exact answers of gears: Willis' equation, the generated tooth."""

"""Drawings to scale that students hand in: read, matched with what should be drawn, and marked line by line."""

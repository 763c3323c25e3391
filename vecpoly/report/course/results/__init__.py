"""Chapters 5 and 6 of a course report: table, curves, paths, and the drawn polygons."""

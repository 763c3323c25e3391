"""Chapters 3 and 4 of a course report: coordinate system, dimensions, the mathematical model."""

"""Drawn against exact, printed against exact."""

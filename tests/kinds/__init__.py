"""Kinds of figure, and a task, that vecpoly does not have: what a lecturer would add."""

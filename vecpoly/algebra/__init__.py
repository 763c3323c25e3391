"""Formulas as a tree, and expressions of quantities: what is printed is what was computed."""

"""Exact answers about structures: ranks of Jacobians, redundant constraints, groups by matching."""

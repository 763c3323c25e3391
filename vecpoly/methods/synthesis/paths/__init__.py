"""Paths of coupler points, traced."""

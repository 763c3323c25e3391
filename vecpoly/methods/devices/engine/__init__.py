"""Inertia forces and couples of engines."""

"""Pressure and transmission angles marked in a given mechanism."""

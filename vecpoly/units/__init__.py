"""Quantities with written units: reading them, their names, and how they may be written."""

"""Loads that depend on place and speed: when they act, how large they are, springs and dampers."""

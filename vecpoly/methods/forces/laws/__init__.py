"""Loads that depend on place and speed, read off the sheet."""

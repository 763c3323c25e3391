"""Exact answers for devices: one device, one file."""

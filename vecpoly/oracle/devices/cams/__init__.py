"""Exact cams: laws of motion, pitch curve with its derivatives, least base circle."""

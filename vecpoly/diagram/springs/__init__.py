"""Symbols of springs and dampers (GB/T 4460)."""

"""Symbols of machines and forces: marks, and what each looks like on paper."""

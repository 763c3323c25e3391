"""Rotors that are balanced, from their masses or from what a vibrometer shows."""

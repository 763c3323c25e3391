"""Exact answers of rotors: sums of complex numbers and linear systems, without a lever or a polygon."""

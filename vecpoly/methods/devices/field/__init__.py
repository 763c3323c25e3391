"""Balancing where the rotor runs: influence coefficient, and four runs without phase."""

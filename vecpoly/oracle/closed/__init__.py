"""Dyads in closed form."""

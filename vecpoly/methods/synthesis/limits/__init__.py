"""Limit positions: linkages that are found by them, and what is asked of linkages that have them."""

"""The four constructions."""

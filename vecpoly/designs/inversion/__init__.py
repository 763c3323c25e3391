"""Linkages through given positions: all of them are found by inversion, one pin after another."""

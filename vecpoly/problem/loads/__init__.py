"""Loads and friction as written."""

"""Friction, settled by successive approximation."""

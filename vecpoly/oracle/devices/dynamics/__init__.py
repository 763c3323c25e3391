"""Machines in motion, by integrals."""

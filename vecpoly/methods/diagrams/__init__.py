"""Diagrams of one quantity over another: axes, curves, the areas between them, and the energy indicator bar."""

"""The mathematical model of a mechanism: closed formulas of each Assur group, generated from the group, that print and compute."""

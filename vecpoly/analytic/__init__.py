"""The mathematical model of a mechanism: closed formulas of each Assur group, that both print and compute."""

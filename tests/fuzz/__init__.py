"""Trying to break things: damaged problem files and tables, runs that are killed."""

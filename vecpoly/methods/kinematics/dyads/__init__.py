"""Velocity and acceleration of the class II groups, one file each."""

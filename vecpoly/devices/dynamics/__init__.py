"""Machines in motion: flywheels by areas, run-up and braking, trains reduced to one shaft."""

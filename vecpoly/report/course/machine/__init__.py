"""Chapters on the machine: its motion with the flywheel, and what its masses do to the frame."""

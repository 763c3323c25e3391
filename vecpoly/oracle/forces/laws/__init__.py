"""Loads that depend on place and speed: what they ask of the motion, where they jump, their work over a period."""

"""Loads by a law: when they act, and how large they are where a machine is."""

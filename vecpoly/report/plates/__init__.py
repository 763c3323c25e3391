"""Figures and drawing sheets as a report holds them, and what they show in words."""

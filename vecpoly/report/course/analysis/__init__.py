"""Chapters 8 and 9 of a course report: the analysis in words, and the conclusion."""

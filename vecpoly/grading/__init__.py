"""Grading: the key of a solution, what a student wrote, the comparison of both with a reason, marks, files."""

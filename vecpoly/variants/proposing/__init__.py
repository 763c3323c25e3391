"""Ranges for a problem that has none: numbers that may differ from student to student, tried by the pilot."""

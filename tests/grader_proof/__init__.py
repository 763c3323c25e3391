"""The grader against itself: simulated students whose work is known to be right, or wrong in a known way."""

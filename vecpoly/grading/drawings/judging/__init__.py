"""What a drawn vector is worth: against the exact one, and against the student's own lines before it."""

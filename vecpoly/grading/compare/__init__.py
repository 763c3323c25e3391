"""What was written against what is exact, or against what follows from somebody's own values."""

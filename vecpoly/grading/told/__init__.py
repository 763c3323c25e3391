"""What a student is told: sentences by their names, with numbers, in both languages."""

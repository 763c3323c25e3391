"""From a sheet to marks: outcomes, follow-through, causes, points, sentences."""

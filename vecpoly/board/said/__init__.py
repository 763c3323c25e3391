"""What is said of the acts of a sheet: step by step, where a line is evaluated, what is too short, on which side."""

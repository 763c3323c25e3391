"""Random problems, each family in a file of its own, and a judge who compares drawing,
oracle and central differences."""

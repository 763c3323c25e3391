"""Chapter 7 of a course report: the model checked, drawn beside exact, tolerances, the book's answers."""

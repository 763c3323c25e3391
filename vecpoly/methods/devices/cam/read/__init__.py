"""What is read of a cam, and the table of its stations."""

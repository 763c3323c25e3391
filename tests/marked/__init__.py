"""Claims about the marked work of a class."""

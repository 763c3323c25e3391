"""A four-bar whose output turns as a function of its input: the function, its three precision points."""

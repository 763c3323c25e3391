"""A function generator on paper: precision points, the pins by trial cranks and inversion, the error curve."""

"""The step player: a solved problem as one HTML file that draws the construction before the eyes of a class."""

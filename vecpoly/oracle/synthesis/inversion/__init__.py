"""Linkages through given positions in closed form: motions, circles, centre points, defects."""

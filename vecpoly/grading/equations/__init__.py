"""The direction and magnitude rows of the vector equations, in which a student ticks what is given."""

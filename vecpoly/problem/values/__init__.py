"""The values of a problem: where they stand, how they are varied, what is printed of them."""

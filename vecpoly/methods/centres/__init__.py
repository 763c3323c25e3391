"""Instant centres (瞬心): the direct ones, the theorem of three centres, and what follows from them."""

"""What is done otherwise than the hand would do it: somebody's own readings and points, and mistakes."""

"""Groups located with compass and ruler: the kinematic diagram in the given position."""

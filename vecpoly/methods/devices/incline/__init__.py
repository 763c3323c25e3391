"""A block on an inclined plane: sketch, polygon, limit of self-locking."""

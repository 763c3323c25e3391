"""Two wedges: polygons of lifting, without friction and back; limits of self-locking."""

"""What a cycle shows: limits, strokes, transmission angles, breaks, duties of the loads; and its words."""

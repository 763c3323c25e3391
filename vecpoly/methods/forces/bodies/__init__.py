"""Free bodies: links drawn apart with the forces on them, and the polygon of each."""

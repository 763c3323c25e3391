"""What the constructions have in common: normals, pole, axis, triangles, angles carried over, the circle."""

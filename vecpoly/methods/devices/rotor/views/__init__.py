"""A rotor as it is seen: along its axis, and each plane from its end."""

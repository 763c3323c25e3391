"""Gears and racks by their forces: the line of action of their teeth, and pitch points that press like pins."""

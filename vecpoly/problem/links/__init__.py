"""Links as written: points, guide lines, gears, masses, and where they stand."""

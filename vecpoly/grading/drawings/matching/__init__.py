"""Which line of a drawing is which vector: names, layers, scale, and one optimal assignment."""

"""How devices are drawn: sketches, dimensions, block diagrams."""

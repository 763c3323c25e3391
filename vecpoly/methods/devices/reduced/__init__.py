"""A train reduced to one shaft: sketch, ratios, equivalents, run-up."""

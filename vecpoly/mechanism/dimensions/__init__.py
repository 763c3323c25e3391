"""The dimensions of a mechanism, each a value, each varied alone."""

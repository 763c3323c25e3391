"""What is found of a mechanism over its cycle, in words: limits, transmission, conditioning, other lengths."""

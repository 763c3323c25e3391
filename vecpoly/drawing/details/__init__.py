"""Places of a figure that are too crowded to be read, drawn apart and enlarged (局部放大图, GB/T 4458.1)."""

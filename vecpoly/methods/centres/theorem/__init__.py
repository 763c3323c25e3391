"""The theorem of three centres (三心定理): the order of search, its lines, and the trial triangle."""

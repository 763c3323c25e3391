"""Where paper ends: linkages for a path, for a dwell, for the best transmission, by a search over many candidates."""

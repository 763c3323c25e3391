"""GeoGebra files (.ggb): a construction whose objects depend on each other; the input is a slider."""

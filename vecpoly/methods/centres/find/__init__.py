"""What is asked once the centres are found: speeds, ratios, limits, the slowest point."""

"""Groups loaded on both links: moments first, then one polygon."""

"""What is no linkage: wedges, screws, guides, clamps, trains of machines; one device, one file, data only."""

"""How devices are drawn and solved: wedges, screws, clamps, guides, trains of machines; one device, one file."""

"""Every student own numbers: ranges, seeds, the gate."""

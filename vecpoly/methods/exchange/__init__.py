"""A link on the frame thought to drive, where the input acts between two moving links."""

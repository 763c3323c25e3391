"""What is drawn of each sort of problem: one file a sort."""

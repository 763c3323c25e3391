"""What lies about a label: rectangles, pieces of lines in them, solids."""

"""What lies on the paper: marks, how much room they take, and the scales that fit them in."""

"""What a problem asks for, and what is printed beside it."""

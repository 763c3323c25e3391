"""What a question sheet offers: room to work, empty equations and tables, frames to draw in; nothing of the answer."""

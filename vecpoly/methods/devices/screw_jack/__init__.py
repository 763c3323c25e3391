"""A screw jack: the thread, the collar, efficiency and self-locking."""

"""A clamping wedge: self-locking shown in three ways."""

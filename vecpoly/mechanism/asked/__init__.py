"""What may be asked of a mechanism, by key: forces, instant centres."""

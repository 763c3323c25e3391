"""Rules of running text."""

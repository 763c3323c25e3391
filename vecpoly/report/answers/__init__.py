"""The end of every problem: what was asked, with scale, number, unit and direction; one line a quantity."""

"""A class: from a roster to question sheets, solutions, register, key and answer forms for everybody."""

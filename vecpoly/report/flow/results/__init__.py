"""How results are set: the box of answers, numbers under each other by their decimal points."""

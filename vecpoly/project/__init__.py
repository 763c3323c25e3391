"""A design project: several problems that feed each other, from the data of the task to the demands on the machine."""

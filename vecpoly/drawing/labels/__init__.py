"""Lettering: what is to be lettered, where letters could stand, what they must keep clear of, and where they go."""

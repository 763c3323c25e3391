"""Cams: a plate cam by itself, a follower, the contact of discs and faces in a mechanism, and a profile in it."""

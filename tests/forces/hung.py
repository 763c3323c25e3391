"""A four-bar from whose rocker a slide runs to the crank's pivot: a cylinder, or a block in a slot."""

from __future__ import annotations

from vecpoly import Problem, loads

HUNG = """
id: hung
title: hung
frame: {A: [0 mm, 0 mm], D: [400 mm, 0 mm]}
links:
  1: {AB: 100 mm}
  2: {BC: 450 mm}
  3: {DC: 350 mm, F: {along: DC, at: 200 mm, right: 60 mm}}
  4: {OUTER: A}
  5: {INNER: F}
joints: [5 slides in 4]
input: {link: 1, MOVED}
branch: [C left of BD]
"""


def hung(outer: str, inner: str, moved: str, loaded: str) -> Problem:
    """outer, inner: cylinder and piston, or slot and block; moved: the crank's motion; loaded: the rest of the file."""
    return loads(HUNG.replace("OUTER", outer).replace("INNER", inner).replace("MOVED", moved) + loaded)

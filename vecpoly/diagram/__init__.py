"""Symbols of links, joints and bodies, written once: a mechanism as it stands on a figure gives marks (GB/T 4460)."""

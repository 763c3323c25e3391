"""Printed answers checked one by one and together."""

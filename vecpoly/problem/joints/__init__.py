"""Joints, contacts, drives and branch statements, as written."""

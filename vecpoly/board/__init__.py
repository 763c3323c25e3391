"""The emulated sheet of paper."""

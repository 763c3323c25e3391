"""Pins by inversion (刚化反转法): a linkage is thought rigid in one position and laid over into another."""

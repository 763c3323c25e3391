"""Linkages through given positions by inversion (刚化反转法): transfer, bisect, meet, one pin after another."""

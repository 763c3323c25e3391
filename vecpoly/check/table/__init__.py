"""A printed table against exact values: read, weighed, judged, told."""

"""A scene on a canvas: SVG, PDF, PNG, matplotlib; one file each."""

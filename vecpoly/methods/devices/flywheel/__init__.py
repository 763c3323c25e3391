"""The flywheel: areas of the diagram of moments, the energy indicator bar, moment of inertia, rim."""

"""An epicyclic train by Kutzbach's diagrams of velocities and angular velocities."""

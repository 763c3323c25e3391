"""An eccentric clamp: clamping, then self-locking with the force removed."""

"""The mechanism in other positions of its drive: followed there from its own, and drawn on scratch paper."""

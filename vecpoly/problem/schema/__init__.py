"""What a problem file may hold: models, kinds of value, faults told together, warnings."""

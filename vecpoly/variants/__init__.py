"""Every student own numbers: values drawn on a grid by seeds, and a gate that keeps what can be drawn and graded
well."""

"""A link by lines of action: two-force links, three forces through one point, parallel forces, contacts."""

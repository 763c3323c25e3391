"""Chapter 2 of a course report: links, joints and freedom counted, the groups drawn apart."""

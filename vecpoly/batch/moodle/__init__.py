"""Questions for Moodle: cloze and numerical, in its XML format."""

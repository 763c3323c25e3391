"""The mechanism taken apart: degrees of freedom, Assur groups and their class."""

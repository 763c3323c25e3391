"""The marked work of a class: answers read, sheets marked, grades, feedback, item analysis, a queue."""

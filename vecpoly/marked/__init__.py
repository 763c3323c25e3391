"""The marked work of a class: answer files read, sheets marked, grades, feedback, item analysis, what waits for a
person."""

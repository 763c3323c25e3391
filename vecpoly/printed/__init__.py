"""How what was found is printed: one value with the same digits in steps, answers, tables and on sheets."""

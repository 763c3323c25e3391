"""Laws of printed pages: a problem told otherwise, or another to which every number of it leads, has the same pages but
for what must differ. Answers alone are compared by the families `retold-...`; here it is every sentence and line."""

"""The complete assignment report (课程大作业): one problem over its whole cycle, from cover to appendix."""

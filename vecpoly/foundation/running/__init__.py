"""What has to do with the machine that runs the program: processes, garbage, what the operating system refuses."""

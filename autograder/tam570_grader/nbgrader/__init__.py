"""Write a course for nbgrader, and grade inside nbgrader's autograde."""

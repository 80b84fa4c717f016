"""A course that plain nbgrader runs, and our grading inside its autograde."""

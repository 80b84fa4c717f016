"""A course as its teacher has it: which one, what course.toml changes, the rubric, late work."""

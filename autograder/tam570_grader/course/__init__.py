"""The instructor's course: which one it is, what course.toml changes, and late policies."""

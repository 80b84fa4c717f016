"""The course and what is released of it: stubs, notebooks, the students' kit, course.toml."""

"""The course as it is handed on: kit, stubs, notebooks, nbgrader, Gradescope, Canvas and Moodle."""

"""The archive that Gradescope runs, and the results that it reads."""

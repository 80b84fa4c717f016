"""Write the archives that Gradescope runs and the results that it reads."""

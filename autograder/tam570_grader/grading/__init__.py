"""Grade a folder of submissions into results."""

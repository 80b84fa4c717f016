"""From a folder of submissions to results."""

"""Turn results into prose and pictures: feedback pages and the class report."""

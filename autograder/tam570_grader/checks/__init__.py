"""Functions and records with which hidden checks are written."""

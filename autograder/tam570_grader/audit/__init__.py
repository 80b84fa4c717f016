"""Audit the grader: mutants, hidden cases, fairness, diagnosis, margins."""

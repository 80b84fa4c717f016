"""Diagnosis of wrong submissions: known mistakes, transforms of inputs and outputs, mutants of the solution."""

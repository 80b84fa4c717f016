"""The supervisor's side of the sandbox; the package `protocol` runs in the sandbox, beside the student's code."""

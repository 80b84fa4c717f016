"""Code that runs in the sandbox, with the student's code. Nothing here contains a check, an expected value or a score.

The package imports only the standard library, NumPy, msgpack, `tam570` and, when needed, SymPy and Matplotlib. It is
the only part of the grader that the sandbox can read.
"""

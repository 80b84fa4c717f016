"""What runs inside the sandbox, with the student's code. Nothing here knows a check, an expected value or a score.

The package stands alone (standard library, NumPy, msgpack, tam570.notebooks): it is all of the grader that the sandbox
can read.
"""

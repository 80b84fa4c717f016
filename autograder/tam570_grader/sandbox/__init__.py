"""The supervisor's side of the sandbox; `protocol` stands alone and runs beside the student's code."""

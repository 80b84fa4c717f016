"""The supervisor's side of the sandbox; `inside` stands alone and runs beside the student's code."""

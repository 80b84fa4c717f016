"""What did the student do: transforms of inputs and outputs, mutants of the solution, known mistakes."""

"""Does the grader catch what it must? Mutants, fairness, diagnosis, margins."""

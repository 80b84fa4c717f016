"""Right-hand sides compiled by LLVM: from the recorded operations, and from the loops as they stand in Python."""

"""Where a result becomes prose: feedback, report, pictures."""

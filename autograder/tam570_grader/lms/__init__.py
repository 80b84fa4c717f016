"""Exchange with learning management systems: import submissions, export scores and feedback pages."""

"""Results as records: the store on disk, adjustments by hand, and tables."""

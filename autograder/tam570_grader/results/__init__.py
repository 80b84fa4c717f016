"""Results as records: on disk, and compared with earlier ones."""

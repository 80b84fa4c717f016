"""Generate what is released to students: stubs, examples, notebooks, and the kit."""

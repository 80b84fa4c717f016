"""Canvas, Moodle and the like: submissions in, scores and pages out."""

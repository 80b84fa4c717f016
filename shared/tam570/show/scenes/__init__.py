"""The scenes, a module for each: `film(student, parameters, start, seconds)` shows the student's functions.

A scene knows where things are drawn and, in EXAMPLE, START and SECONDS, with what they start. How they move is for
the student's functions to say.
"""

"""The scenes, a module for each: `film(student)` is what to show of the student's functions.

A scene knows where things are drawn and with what they start. How they move is for the student's functions to say.
"""

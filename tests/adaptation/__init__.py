"""Tests of the adaptation: learners, listeners, the experiment."""

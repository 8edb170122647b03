"""Simulated listeners: how engagement answers to X."""

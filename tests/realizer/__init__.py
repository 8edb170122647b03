"""The surface realizer alone: reviewed cases, morphology, properties."""

"""The driver on top of the core: who listens, how engaged, which X next, the storyteller.

It imports `personage_lite`; `personage_lite` never imports it (a checker in CI proves that).
The learners, the sensors and the live storyteller come with later versions.

Source: the paper, sections III and IV.
"""

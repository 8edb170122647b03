"""Style features of texts, by extraversion X, beside their published directions (docs/measure.md).

>>> from personage_lite import Generator
>>> from personage_lite.measure import measure
>>> generator = Generator()
>>> said = [generator.generate("alice", x=x, seed=seed) for x in (-2, 2) for seed in range(20)]
>>> rows = {row.feature.name: row for row in measure(said).rows}
>>> rows["words"].verdict
'agrees'
"""

from personage_lite.measure.features import Feature, Features, load_features
from personage_lite.measure.reading import Said, read_utterances
from personage_lite.measure.report import Group, Report, Row, Value, measure
from personage_lite.measure.richness import Richness, Worn

__all__ = [
    "Feature",
    "Features",
    "Group",
    "Report",
    "Richness",
    "Row",
    "Said",
    "Value",
    "Worn",
    "load_features",
    "measure",
    "read_utterances",
]

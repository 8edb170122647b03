"""Where the shipped data stands: inside an installed wheel, or beside the package in a checkout."""

from __future__ import annotations

from os.path import dirname, isdir, join

from personage_lite.errors import PersonageError


def data_folder(name: str) -> str:
    """Return the path of the folder `lexicons` or `facts`.

    A plain path, not `importlib.resources` nor `pathlib`: pip always unpacks, and the first
    utterance comes sooner. Raises `PersonageError` if the installation has lost its data.
    """
    package = dirname(__file__)
    for folder in (join(package, "_data", name), join(dirname(package), name)):
        if isdir(folder):
            return folder
    raise PersonageError(f"the folder '{name}' is missing; install personage-lite again")

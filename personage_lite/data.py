"""Where the shipped data stands: inside an installed wheel, or beside the package in a checkout."""

from __future__ import annotations

from pathlib import Path

from personage_lite.errors import PersonageError


def data_folder(name: str) -> Path:
    """Return the folder `lexicons` or `facts`.

    A plain path, not `importlib.resources`: pip always unpacks, and the first utterance comes
    sooner. Raises `PersonageError` if the installation has lost its data.
    """
    package = Path(__file__).parent
    for folder in (package / "_data" / name, package.parent / name):
        if folder.is_dir():
            return folder
    raise PersonageError(f"the folder '{name}' is missing; install personage-lite again")

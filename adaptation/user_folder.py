"""The user's own folder for what the storyteller keeps: the memory's file, and session logs."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path


def user_folder(environment: Mapping[str, str] = os.environ, platform: str = sys.platform) -> Path:
    """Return the folder: where the system keeps users' data.

    `$XDG_DATA_HOME/personage-lite`, by default under `~/.local/share`; on Windows under
    `%LOCALAPPDATA%`.

    >>> user_folder({"XDG_DATA_HOME": "/data"}, "linux").as_posix()
    '/data/personage-lite'
    """
    named = environment.get("LOCALAPPDATA" if platform == "win32" else "XDG_DATA_HOME", "")
    if not os.path.isabs(named):  # as the XDG specification says: then it counts as not given
        home = environment.get("HOME") or str(Path.home())
        named = os.path.join(home, ".local", "share")
    return Path(named) / "personage-lite"


def make_private(folder: Path) -> None:
    """Make a folder that only the user can read; those above it as is usual.

    Raises `OSError` if it cannot be made.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)

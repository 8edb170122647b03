"""setuptools' build backend, which also asks for mypy if the wheel is to be compiled (setup.py).

pip builds in an environment of its own that holds only what is asked for: here, so that the plain
build needs no mypy.
"""

from __future__ import annotations

import os
from typing import Any

from setuptools import build_meta
from setuptools.build_meta import *  # noqa: F403 - all other hooks are setuptools' own


def get_requires_for_build_wheel(config_settings: Any = None) -> list[str]:
    """Return what building the wheel needs besides setuptools."""
    needed: list[str] = build_meta.get_requires_for_build_wheel(config_settings)
    if os.environ.get("PERSONAGE_LITE_COMPILE") == "1":
        needed += ["mypy[mypyc]>=2.4", "types-PyYAML>=6"]
    return needed

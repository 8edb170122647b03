"""`python -m personage_lite generate …`: the command without an installation."""

from __future__ import annotations

import sys

from personage_lite.cli import main

sys.exit(main())

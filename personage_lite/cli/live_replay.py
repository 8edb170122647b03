"""`live --replay`: says the words of a session log again, verifies them, and compares learners."""

from __future__ import annotations

import argparse
import sys
import time

from personage_lite.cli.generate import say_whole
from personage_lite.errors import PersonageError


def replay(arguments: argparse.Namespace) -> None:
    """Say a log's words again; exit 1 at the first that differ."""
    from adaptation.storyteller.comparing import compared
    from adaptation.storyteller.kept_logs import last_log, log_folder
    from adaptation.storyteller.pace import seconds_to_say
    from adaptation.storyteller.replaying import replayed
    from adaptation.storyteller.session_log import read_sessions
    from personage_lite.cli.live import generator_for, speed_of

    speed = speed_of(arguments.speed)
    log = arguments.replay or last_log(log_folder())
    for session in read_sessions(log):
        if arguments.compare:
            say_whole(compared(session), sys.stdout)
            continue
        facts = arguments.facts or session.header.fields.get("settings", {}).get("facts")
        generator = generator_for(facts)
        count = 0
        for line in replayed(session, generator, log):
            print(line.text, flush=True)
            count += line.said
            # At a terminal one reads along; elsewhere it is the words that matter.
            if speed and line.said and sys.stdout.isatty():
                time.sleep(seconds_to_say(line.text, line.x) / speed)
        if not count:
            raise PersonageError(f"{log}: nothing was said in it; nothing is verified")
        print(f"personage-lite: {count} utterances, all as in the log", file=sys.stderr)

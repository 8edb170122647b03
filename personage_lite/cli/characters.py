"""`characters`: lists who can be talked about."""

from __future__ import annotations

import argparse

HELP = "list who can be talked about, with how many facts"
EXAMPLE = "personage-lite characters --format json"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    command.add_argument("--facts", metavar="PATH", help="your own facts: a file or a folder")
    command.add_argument("--format", choices=("text", "json"), default="text")


def run(arguments: argparse.Namespace) -> None:
    """Print one line a character."""
    from personage_lite.data import data_folder
    from personage_lite.facts_reader import character_files, read_character

    place = data_folder("facts") if arguments.facts is None else arguments.facts
    found = [read_character(path) for path in character_files(place).values()]
    width = max(len(character.entity.id) for character in found)
    for character in found:
        entity = character.entity
        if arguments.format == "json":
            import json

            record = {"character": entity.id, "name": entity.name, "facts": len(character.facts)}
            print(json.dumps(record, ensure_ascii=False))
        else:
            count = len(character.facts)
            print(f"{entity.id:<{width}}  {count:>3} fact{'s' * (count != 1):1}  {entity.name}")

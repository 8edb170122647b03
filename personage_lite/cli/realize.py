"""`realize`: says the sentences of a specification file, with the realizer alone."""

from __future__ import annotations

import argparse

from personage_lite.cli.content import content
from personage_lite.errors import PersonageError

HELP = "say the sentences that a YAML or JSON file specifies: the realizer alone"
EXAMPLE = "echo '{verb: run, subject: Alice}' | personage-lite realize -"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add("file", nargs="?", help="a YAML or JSON file (docs/realizer.md), or - for standard input")
    add("--format", choices=("text", "json"), default="text", help="text, or JSON lines")
    add("--dialect", choices=("british", "american"), default="british", help="spelling and forms")
    add("--oxford-comma", action="store_true", help='a comma before the last "and" of a list')
    add("--curly-apostrophes", action="store_true", help="’ instead of '")
    add("--lexicons", metavar="PATH", help="your own lexicons: a copy of the folder, edited")
    add("--schema", action="store_true", help="print the JSON Schema of such files instead")


def run(arguments: argparse.Namespace) -> None:
    """Read the whole file, then print a line for each of its sentences."""
    if arguments.schema:
        from personage_lite.realizer.schema import schema_text

        print(schema_text())
        return
    if arguments.file is None:
        raise PersonageError("no file to realize; name one, or - for standard input")
    given, name = content(arguments.file)
    from personage_lite.data import data_folder
    from personage_lite.realizer import Realizer
    from personage_lite.realizer.files import realize_file
    from personage_lite.realizer.grammar import load_grammar

    grammar = load_grammar(
        arguments.lexicons or data_folder("lexicons"),
        arguments.dialect,
        arguments.oxford_comma,
        arguments.curly_apostrophes,
    )
    # All are realized before any is printed: a fault in the last leaves no half output.
    texts = realize_file(given, name, Realizer(grammar))
    if arguments.format == "json":
        from json import dumps

        texts = [dumps({"text": text}, ensure_ascii=False) for text in texts]
    for text in texts:
        print(text)

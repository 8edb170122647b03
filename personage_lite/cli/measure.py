"""`measure`: style features of a text or a corpus, by extraversion X."""

from __future__ import annotations

import argparse

from personage_lite.cli.content import content
from personage_lite.errors import PersonageError

HELP = "measure the style of a text or a corpus, by X, beside the published directions"
EXAMPLE = "personage-lite measure corpus.jsonl --plot style.png"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = command.add_argument
    add("file", help="JSON lines as generate and corpus make them, or a text; - for standard input")
    add("--plot", metavar="FILE", help="draw the features by X: a .png, .svg or .pdf file")
    add("--richness", action="store_true", help="add how often the same is said in the same words")
    add("--format", choices=("text", "json"), default="text", help="text, or JSON lines")
    add("--lexicons", metavar="PATH", help="your own lexicons: a copy of the folder, edited")


def run(arguments: argparse.Namespace) -> None:
    """Print the report, after the plot is written."""
    from personage_lite.measure.extras import imported
    from personage_lite.measure.plot import check_plot_path, plot

    if arguments.plot is not None:  # What would stop it is said before the long work.
        check_plot_path(arguments.plot)
        imported("matplotlib")
    given, name = content(arguments.file)
    from personage_lite.measure.reading import read_utterances
    from personage_lite.measure.report import measure
    from personage_lite.measure.table import records, table

    utterances = read_utterances(given, name)
    if arguments.plot is not None and len({said.x for said in utterances}) < 2:
        raise PersonageError(f"{name} has not two X to plot; give records of several X")
    report = measure(utterances, arguments.lexicons)
    if arguments.plot is not None:
        plot(report, arguments.plot)
    if arguments.format == "json":
        from json import dumps

        for record in records(report, arguments.richness):
            print(dumps(record, ensure_ascii=False))
    else:
        print(table(report, arguments.richness))

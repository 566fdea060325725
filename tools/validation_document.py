"""docs/validation.md as chapters, so that each program renews its own and leaves the others."""
import csv
import json
import pathlib
import re

path = pathlib.Path(__file__).resolve().parent.parent / "docs/validation.md"


def renew(chapters, preface=None):
    """Puts chapters {"1. Title": text} in the place of those of the same title; the rest stays. In order of their numbers."""
    parts = re.split(r"(?m)^## (.*)$", path.read_text()) if path.exists() else [""]
    standing = dict(zip(parts[1::2], parts[2::2]))
    standing.update(chapters)
    ordered = sorted(standing.items(), key=lambda item: int(item[0].split(".")[0]))
    text = (preface or parts[0]).strip() + "\n"
    for title, body in ordered:
        text += f"\n## {title}\n\n{body.strip()}\n"
    path.write_text(text)


def table(head, body):
    """Lines of a table."""
    rows = ["| " + " | ".join(row) + " |" for row in (head, *body)]
    return [rows[0], "|" + "---|" * len(head), *rows[1:], ""]


def is_done(folder):
    """Is this the results folder of a run that came to its end?"""
    manifest = folder / "manifest.json"
    return manifest.exists() and json.loads(manifest.read_text())["exit_code"] == 0


def rows_of(file):
    """Rows of a series as dictionaries, numbers as such."""

    def number(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(file, newline="") as lines:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(lines)]

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of JSON's keys in docs/results.md, from what the program says of its documents.

tests/docs/result_tables.py PROGRAM          exits 1 where the page is not as it would be written
tests/docs/result_tables.py PROGRAM --write  writes it
"""

import json
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "results.md"
MARK = "<!-- From here on written by tests/docs/result_tables.py, from `coppermoon describe --json`. -->\n"
ABSENT = {"null": "; may be null", "absent": "; left out where there is none"}


def kind(field):
    """"number", "list of objects", "object of numbers"."""
    if field["kind"] == "list":
        return f"list of {field['of']}s"
    return f"object of {field['of']}s" if field["kind"] == "by-name" else field["kind"]


def rows(fields, before=""):
    """A row for each key, then those of its parts."""
    for field in fields:
        key = before + field["key"]
        words = f" ({', '.join(field['words'])})" if "words" in field else ""
        told = (field["meaning"] + words + ABSENT.get(field.get("may_be"), "")).replace("|", "\\|")
        yield f"| `{key}` | {kind(field)} | {field.get('unit', '')} | {told} |\n"
        yield from rows(field.get("fields", []), key + ("[]." if field["kind"] == "list" else "."))


def tables(description):
    page = MARK
    for command in description["commands"]:
        page += f"\n## {command['name']}\n" if "documents" in command else ""
        for document in command.get("documents", []):
            several = "A list; each is: " if document["many"] else ""
            page += f"\n{several}{document['meaning']}\n\n"
            page += "| key | value | unit | meaning |\n| --- | --- | --- | --- |\n"
            page += "".join(rows(document["fields"]))
    return page


def main():
    program = sys.argv[1]
    told = subprocess.run([program, "describe", "--json"], check=True, capture_output=True, text=True)
    written = PAGE.read_text()
    wanted = written.split(MARK)[0] + tables(json.loads(told.stdout))
    if "--write" in sys.argv:
        PAGE.write_text(wanted)
    elif written != wanted:
        sys.exit(f"{PAGE.name}: its tables are not those of {program}; run tests/docs/result_tables.py {program} --write")


if __name__ == "__main__":
    main()

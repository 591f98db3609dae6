#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of keys in docs/recipes.md, and of files in docs/textures.md, from what the program says of its parameters.

tests/docs/recipe_tables.py PROGRAM          exits 1 where the page is not as it would be written
tests/docs/recipe_tables.py PROGRAM --write  writes it
"""

import json
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
MARK = "<!-- From here on written by tests/docs/recipe_tables.py, from `coppermoon describe --json`. -->\n"
FIRST = "The moment, the Moon, and what one command has alone"
REGION = "Parts of a region"
FILES = "<!-- Written by tests/docs/recipe_tables.py. -->\n"


def meaning(parameter):
    """Meaning, and the words that it does not name, as help has them."""
    words, told = parameter.get("words", []), parameter["meaning"]
    if any(word not in told for word in words):
        told += ": " + ", ".join(words)
    return told.replace("|", "\\|")


def default(parameter):
    """" (default 1)"; empty where there is none."""
    has = "default" in parameter and parameter["kind"] != "presence"
    return f" (default {parameter['default']})" if has else ""


def text(parameter):
    return meaning(parameter) + default(parameter)


def row(name, by_command):
    """A key's row. The first command's meaning holds for all but those that have one of their own."""
    first = next(iter(by_command.values()))
    others = {}
    for command, parameter in by_command.items():
        if text(parameter) != text(first):
            alike = meaning(parameter) == meaning(first)
            told = default(parameter) if alike else ": " + text(parameter)
            others.setdefault(told, []).append(f"`{command}`")
    told = text(first) + "".join(f"; of {', '.join(commands)}{other}" for other, commands in others.items())
    return f"| `{name}` | {told} | {', '.join(by_command)} |\n"


def tables(description):
    """All tables, in the order in which the program first names their headings and keys."""
    headings, keys, parts = {}, {}, {}
    for command in description["commands"]:
        for parameter in filter(lambda one: one["recipe"], command["parameters"]):
            name = parameter["name"]
            keys.setdefault(name, {})[command["name"]] = parameter
            headings[name] = headings.get(name) or parameter.get("heading")
            parts |= {part["name"]: text(part) for part in parameter.get("parts", [])}
    titles = dict.fromkeys([FIRST, *(heading or FIRST for heading in headings.values())])
    page = MARK
    for title in titles:
        page += f"\n### {title}\n\n| key | what it is | commands |\n| --- | --- | --- |\n"
        page += "".join(row(name, keys[name]) for name in keys if (headings[name] or FIRST) == title)
    page += f"\n### {REGION}\n\n| key | what it is |\n| --- | --- |\n"
    return page + "".join(f"| `{name}` | {told} |\n" for name, told in parts.items())


def files(description):
    """Commands and the files that they write by their endings."""
    page = FILES + "\n| command | option | files |\n| --- | --- | --- |\n"
    for command in description["commands"]:
        for parameter in filter(lambda one: "endings" in one, command["parameters"]):
            told = (f"`{ending}`" + (f" ({holds})" if holds else "")
                    for ending, holds in parameter["endings"].items())
            page += f"| `{command['name']}` | `--{parameter['name']}` | {', '.join(told)} |\n"
    return page + "\n" + FILES


def main():
    program = sys.argv[1]
    told = subprocess.run([program, "describe", "--json"], check=True, capture_output=True, text=True)
    description = json.loads(told.stdout)
    recipes, textures = DOCS / "recipes.md", DOCS / "textures.md"
    before, _, after = textures.read_text().split(FILES)
    for page, wanted in ((recipes, recipes.read_text().split(MARK)[0] + tables(description)),
                         (textures, before + files(description) + after)):
        if "--write" in sys.argv:
            page.write_text(wanted)
        elif page.read_text() != wanted:
            sys.exit(f"{page.name}: its tables are not those of {program}; run tests/docs/recipe_tables.py {program} --write")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A dictionary of libFuzzer: the words of a file, then what the program says of its parameters.

coppermoon describe --json | tests/fuzz/dictionary.py (flags|recipe|words) FILE >DICTIONARY
"""

import json
import sys


def parameters(description):
    """All parameters and parts, each name once."""
    everything = {}
    for command in description["commands"]:
        for parameter in command["parameters"]:
            for one in [*parameter.get("parts", []), parameter]:
                everything.setdefault(one["name"], one)
    return everything.values()


def entries(grammar, description):
    """Words of a command line, of a recipe, or of a region."""
    if grammar == "flags":
        yield from (command["name"] + "\\x0a" for command in description["commands"])
    if grammar == "recipe":
        yield from {f"[{one['table']}]" for one in parameters(description) if one.get("table")}
    for one in parameters(description):
        name = one["name"]
        if grammar == "flags":
            yield f"--{name}\\x0a" if one["kind"] == "presence" else f"--{name}="
        elif grammar == "recipe":
            yield f"{name} = "
        elif one.get("table") == "atmosphere":
            yield f"{name}="
        yield from one.get("words", [])
        yield from (f"{end:g}" for end in one.get("range", []))


def main():
    grammar, file = sys.argv[1:]
    lines = open(file).read().splitlines()
    for entry in sorted(set(entries(grammar, json.load(sys.stdin)))):
        lines.append(f'"{entry}"')
    print("\n".join(dict.fromkeys(lines)))


if __name__ == "__main__":
    main()

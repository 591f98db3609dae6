#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The night of docs/chase.md, as the program prints it: its moments in one block, its exposures in the next.

tests/docs/printed_night.py PROGRAM          exits 1 where the page differs, and shows how
tests/docs/printed_night.py PROGRAM --write  writes the page
"""

import difflib
import pathlib
import re
import shlex
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "chase.md"
BLOCK = re.compile(r"(?<=^```\n)(?:Total eclipse|Exposure times).*?(?=^```$)", re.MULTILINE | re.DOTALL)


def main():
    program, page = sys.argv[1], PAGE.read_text()
    command = re.search(r"^coppermoon (night .*)$", page, re.MULTILINE)[1]
    told = subprocess.run([program, *shlex.split(command)], check=True, capture_output=True, text=True).stdout
    moments, exposures = re.sub(" +$", "", told, flags=re.MULTILINE).split("\n\nExposure times")
    blocks = iter([moments + "\n", "Exposure times" + exposures])
    wanted = BLOCK.sub(lambda block: next(blocks, block[0]), page)
    if "--write" in sys.argv:
        PAGE.write_text(wanted)
    elif wanted != page:
        sys.exit("\n".join(difflib.unified_diff(page.splitlines(), wanted.splitlines(), "docs/chase.md", "printed", "", "", 0, "")))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures that several pages show: each is measured by a script on one page, and the others repeat it.

tests/docs/figures.py          exits 1 where a page has another figure than the page that it was measured on
tests/docs/figures.py --write  fills them in
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BRIGHTNESS, PLANNED = "examples/eclipse_brightness.md", "tests/measurements/planned_runs.md"
ACROSS = r"light across the umbra[^|]*\|[^|]*\|[^|]*?"

# (page, pattern) of the measured figure, then of each that repeats it: the group is the figure, without its sign
FIGURES = [
    [(BRIGHTNESS, r"(?s)by instruments\n.*?\| rms \|[ |]*([\d.]+)"),
     ("README.md", r"five eclipses \| instruments, to 0.1 mag \| ([\d.]+) mag rms in `standard`"),
     ("docs/exactness.md", r"2014 \| instruments, to 0.1 mag \| ([\d.]+) mag rms")],
    [(BRIGHTNESS, r"(?s)by instruments\n.*?\| mean \|[ |]*[+−]([\d.]+)"),
     ("docs/exactness.md", r"2014 \| instruments, .* mag rms, ([\d.]+) fainter")],
    [(BRIGHTNESS, r"rms; factors of all \| ([\d.]+) \|"), ("docs/air.md", r"in `standard`, within ([\d.]+)\.")],
    [(BRIGHTNESS, r"rms; factors of all \| [\d.]+ \| ([\d.]+) \|"),
     ("docs/air.md", r"within\s+([\d.]+) mag rms; in `standard`")],
    [(BRIGHTNESS, r"the umbra \| rms [\d.]+ \| rms ([\d.]+) \|"),
     ("README.md", ACROSS + r"([\d.]+) in `calibrated`"), ("docs/exactness.md", r"; ([\d.]+) when fitted to the five alone")],
    [(BRIGHTNESS, r"rms ([\d.]+) in `standard`, [\d.]+ in `calibrated`\."),
     ("docs/air.md", r"\(([\d.]+) mag rms against [\d.]+\)")],
    [(BRIGHTNESS, r"rms [\d.]+ in `standard`, ([\d.]+) in `calibrated`\."),
     ("docs/air.md", r"\([\d.]+ mag rms against ([\d.]+)\)")],
    [(BRIGHTNESS, r"\| `standard` \| ([\d.]+) \|"),
     ("README.md", ACROSS + r"([\d.]+) and [\d.]+ mag rms in `standard`"),
     ("docs/exactness.md", ACROSS + r"([\d.]+) and [\d.]+ mag rms")],
    [(BRIGHTNESS, r"\| `standard` \| (?:[^|]*\| ){3}([\d.]+) \|"),
     ("README.md", ACROSS + r"[\d.]+ and ([\d.]+) mag rms in `standard`"),
     ("docs/exactness.md", ACROSS + r"[\d.]+ and ([\d.]+) mag rms")],
    [(BRIGHTNESS, r"\| `calibrated` \| ([\d.]+) \|"), ("docs/exactness.md", r"mag rms; ([\d.]+) and [\d.]+ in `calibrated`")],
    [(BRIGHTNESS, r"\| `calibrated` \| (?:[^|]*\| ){3}([\d.]+) \|"),
     ("docs/exactness.md", r"mag rms; [\d.]+ and ([\d.]+) in `calibrated`")],
    [(BRIGHTNESS, r"(?s)## By observers.*?\| mean \|[ |]*\+([\d.]+)"),
     ("docs/exactness.md", r"observers, who differ .*? \| ([\d.]+) mag brighter")],
    [(BRIGHTNESS, r"2015-09-28 .*?\+([\d.]+)"), ("docs/exactness.md", r"brighter on average, ([\d.]+) at worst \(2015\)")],
    [(BRIGHTNESS, r"(?s)foretells from .*?\| mean \|[ |]*\+([\d.]+)"),
     ("docs/exactness.md", r"Vital's trend, .*? \| ([\d.]+) mag brighter")],
    [(PLANNED, r"random air \| 100 \|\n.*\n\| the predicted error bounds the true one \| (\d+)"),
     ("docs/speed.md", r"bounds the true one in (\d+)\.")],
    [(PLANNED, r"(?s)random air \| 100 \|.*?factor of two \| (\d+)"), ("docs/speed.md", r"factor of two in (\d+)\.")],
    [(PLANNED, r"region \| 20 \|\n.*\n\| the predicted error bounds the true one \| (\d+)"),
     ("docs/speed.md", r"sharp border, it is (\d+) and")],
    [(PLANNED, r"(?s)region \| 20 \|.*?factor of two \| (\d+)"), ("docs/speed.md", r"it is \d+ and (\d+) of 20")],
]


def found(page, pattern):
    match = re.search(pattern, (ROOT / page).read_text())
    return match or sys.exit(f"{page}: has no figure at {pattern}")


def main():
    wrong = 0
    for measured, *repeated in FIGURES:
        figure = found(*measured)[1]
        for page, pattern in repeated:
            match = found(page, pattern)
            if match[1] == figure:
                continue
            if "--write" in sys.argv:
                text = match.string
                (ROOT / page).write_text(text[:match.start(1)] + figure + text[match.end(1):])
            else:
                print(f"{page}: has {match[1]} where {measured[0]} has {figure}: {match[0]}", file=sys.stderr)
                wrong += 1
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()

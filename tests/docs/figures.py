#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures that several pages show: each has one page where it is measured or asserted, and the others repeat it.

A page that is to show a figure of another page gets a line here.

tests/docs/figures.py          exits 1 where a page has another figure than the page that it was measured on
tests/docs/figures.py --write  fills them in
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BRIGHTNESS, PLANNED = "examples/eclipse_brightness.md", "tests/measurements/planned_runs.md"
EXACT, CAMERAS = "docs/exactness.md", "docs/cameras.md"
ACROSS = r"light across the umbra[^|]*\|[^|]*\|[^|]*?"

# (page, pattern) of the measured figure, then of each that repeats it: the group is the figure, without its sign
FIGURES = [
    [(BRIGHTNESS, r"(?s)by instruments\n.*?\| rms \|[ |]*([\d.]+)"),
     ("README.md", r"five eclipses \| instruments, to 0.1 mag \| ([\d.]+) mag rms in `standard`"),
     (EXACT, r"2014 \| instruments, to 0.1 mag \| ([\d.]+) mag rms")],
    [(BRIGHTNESS, r"(?s)by instruments\n.*?\| mean \|[ |]*[+−]([\d.]+)"),
     (EXACT, r"2014 \| instruments, .* mag rms, ([\d.]+) mag fainter")],
    [(BRIGHTNESS, r"rms; factors of all \| ([\d.]+) \|"),
     ("docs/air.md", r"with the `standard` air,\s+they\s+agree\s+to\s+([\d.]+)\s+mag")],
    [(BRIGHTNESS, r"rms; factors of all \| [\d.]+ \| ([\d.]+) \|"),
     ("docs/air.md", r"agree to\s+([\d.]+) mag\s+rms; with the `standard`")],
    [(BRIGHTNESS, r"the umbra \| rms [\d.]+ \| rms ([\d.]+) \|"),
     ("README.md", ACROSS + r"([\d.]+) in `calibrated`"), (EXACT, r"; ([\d.]+) when fitted to the five alone")],
    [(BRIGHTNESS, r"rms ([\d.]+) in `standard`, [\d.]+ in `calibrated`\."),
     ("docs/air.md", r"\(([\d.]+) mag\s+rms against [\d.]+\)")],
    [(BRIGHTNESS, r"rms [\d.]+ in `standard`, ([\d.]+) in `calibrated`\."),
     ("docs/air.md", r"\([\d.]+ mag\s+rms against ([\d.]+)\)")],
    [(BRIGHTNESS, r"\| `standard` \| ([\d.]+) \|"),
     ("README.md", ACROSS + r"([\d.]+) and [\d.]+ mag rms in `standard`"),
     (EXACT, ACROSS + r"([\d.]+) and [\d.]+ mag rms")],
    [(BRIGHTNESS, r"\| `standard` \| (?:[^|]*\| ){3}([\d.]+) \|"),
     ("README.md", ACROSS + r"[\d.]+ and ([\d.]+) mag rms in `standard`"),
     (EXACT, ACROSS + r"[\d.]+ and ([\d.]+) mag rms")],
    [(BRIGHTNESS, r"\| `calibrated` \| ([\d.]+) \|"), (EXACT, r"mag rms; ([\d.]+) and [\d.]+ in `calibrated`")],
    [(BRIGHTNESS, r"\| `calibrated` \| (?:[^|]*\| ){3}([\d.]+) \|"),
     (EXACT, r"mag rms; [\d.]+ and ([\d.]+) in `calibrated`")],
    [(BRIGHTNESS, r"(?s)## By observers.*?\| mean \|[ |]*\+([\d.]+)"),
     (EXACT, r"observers, who differ .*? \| ([\d.]+) mag brighter")],
    [(BRIGHTNESS, r"2015-09-28 .*?\+([\d.]+)"), (EXACT, r"brighter on average, ([\d.]+) mag at worst \(2015\)")],
    [(BRIGHTNESS, r"(?s)Vital (?:foretells|predicts) .*?\| mean \|[ |]*\+([\d.]+)"),
     (EXACT, r"Vital's trend, .*? \| ([\d.]+) mag brighter")],
    [(PLANNED, r"random air \| 100 \|\n.*\n\| the predicted error bounds the true one \| (\d+)"),
     ("docs/speed.md", r"bounds the true one in (\d+) cases")],
    [(EXACT, r"1951 to 2025 \| [\d.]+ s \| ([\d.]+) s"), ("README.md", r"\| ([\d.]+) s off on average")],
    [(EXACT, r"1951 to 2025 \| ([\d.]+) s"), ("README.md", r"off on average, ([\d.]+) s at worst")],
    [(EXACT, r"larger the umbra is than its geometry \|[^|]*\| ([\d.]+ to [\d.]+) %"),
     ("README.md", r"enlargement of the umbra \|[^|]*\| ([\d.]+ to [\d.]+) %")],
    [(EXACT, r"larger the umbra is than its geometry \| ([\d.]+ to [\d.]+) %"),
     ("README.md", r"enlargement of the umbra \| ([\d.]+ to [\d.]+) %")],
    [(EXACT, r"the double integral added up, [^|]*\| (\S+) \|"),
     ("README.md", r"against an independent integral \|[ |]*(\S+) \|")],
    [(EXACT, r"sasktran2 [\d.]+, scattered once \| ([\d.]+) %"),
     ("docs/physics.md", r"scattered once agrees with ours\s+to ([\d.]+) %")],
    [(EXACT, r"clear air / aerosol \| (\d+) %"),
     ("docs/physics.md", r"On the axis,\s+this\s+light\s+would\s+add\s+(\d+) %\s+\(blue\)")],
    [(EXACT, r"clear air / aerosol \| \d+ % / (\d+) % of it"),
     ("docs/physics.md", r"2 to (\d+) % with aerosol"), ("README.md", r"more than once \(2 to (\d+) %")],
    [(EXACT, r"mean ([\d.]+ to [\d.]+), largest"), (CAMERAS, r"wrong\s+by\s+([\d.]+ to [\d.]+)\s+on average")],
    [(EXACT, r"largest ([\d.]+ to [\d.]+) \|"), (CAMERAS, r"and\s+by\s+([\d.]+ to [\d.]+)\s+at worst")],
    [(CAMERAS, r"found the dust\s+within\s+(\d+) %\s+and\s+the\s+cover\s+within\s+[\d.]+\s+in\s+all"),
     (EXACT, r"nights of JPEGs, [^|]*\|[^|]*\| dust within (\d+) %")],
    [(CAMERAS, r"the\s+cover\s+within\s+([\d.]+)\s+in\s+all"),
     (EXACT, r"nights of JPEGs, [^|]*\|[^|]*\| dust within \d+ %, cloud within ([\d.]+)")],
    [("docs/shader.md", r"one image of ([\d.]+) MB"), ("README.md", r"the\s+whole\s+eclipse\s+in\s+([\d.]+)\s+MB")],
    [("docs/platforms.md", r"The archive takes (\d+) MB"), ("docs/start.md", r"one file, (\d+) MB")],
    [("CONTRIBUTING.md", r"every change \| (\d+) minutes from nothing"),
     ("README.md", r"and passes the tests; (\d+) minutes")],
    [("README.md", r"renders a picture; (\d+) minutes"),
     ("docs/start.md", r"in about\s+(\d+) minutes"),
     ("examples/README.md", r"simulation\. It takes (\d+) minutes on two")],
    [(PLANNED, r"(?s)random air \| 100 \|.*?factor of two \| (\d+)"),
     ("docs/speed.md", r"factor of two in (\d+) cases")],
    [(PLANNED, r"region \| 20 \|\n.*\n\| the predicted error bounds the true one \| (\d+)"),
     ("docs/speed.md", r"sharp border, these counts are (\d+)\s+and")],
    [(PLANNED, r"(?s)region \| 20 \|.*?factor of two \| (\d+)"),
     ("docs/speed.md", r"counts are \d+\s+and\s+(\d+)\s+of\s+20")],
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

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Benchmarks kept by commit, and how they changed since the commit kept before. Four minutes on two processors.

tests/benchmarks/history.py [--rounds N] [--into FILE]

Appends commit, date, name, median, least, largest and unit of each benchmark to FILE (history.csv beside this script), and
prints them beside those of the last other commit there. Marked is what rose by more than a tenth and beyond the spread of
both. No time fails. A few --rounds make a quick try (5).

Times are processor seconds, user and system, of a command with all its children. Each stands over the time of another
command in the same round: a machine that is slow or busy slows both. Kernels are times of Google Benchmark; before they are
compared they are divided by the row `yardstick` of the same commit.
"""

import argparse
import csv
import datetime
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
RELEASE = ROOT / "build" / "release"
HEAD = ["commit", "date", "name", "median", "least", "largest", "unit"]
ENOUGH_S = 20  # of processor time: a command that has taken so much is not run again

YARDSTICK = "yardstick"  # work of another program
DATE = "2008-02-21T03:26:05Z"
SMALL = "--texture-width 64"  # nearly light alone
BANDS = " ".join(f"--region from-latitude={south},to-latitude={south + 30},ozone-factor={factor}"
                 for south, factor in zip(range(-90, 90, 30), (0.9, 1.1, 0.8, 1.2, 0.95, 1.05)))
STILL = "2018-07-27 --at Nairobi --width 1920 --height 1080"
COMMANDS = {
    "bake": f"coppermoon bake {DATE} --texture-width 4096 -o bake.exr",
    YARDSTICK: "oiiotool bake.exr --compression piz -o again.exr",
    "month": f"coppermoon bake {DATE} {SMALL} -o light.exr",
    "undated": f"coppermoon bake {DATE} {SMALL} --atmosphere undated -o light.exr",
    "bands": f"coppermoon shader {DATE} -o shader {BANDS}",
    "no bands": f"coppermoon shader {DATE} -o shader",
    "still": f"coppermoon still {STILL} -o still.png",
    "povray": "povray eclipse.ini +Oagain.exr -D -P -V",  # and the window that `still` asked for
    "explore": "coppermoon explore 2018-07-27 -o page.html",
    "night": "coppermoon night 2026-03-03 --at Honolulu",
    "tradeoff": "coppermoon tradeoff --quick -o tradeoff",
}
RATIOS = [  # name, what is timed, what it is over, what is taken off first
    ("bake of 4096 texels / oiiotool rewriting it", "bake", YARDSTICK, None),
    ("light in the air of a month / undated", "month", "undated", None),
    ("shader of a moment, six bands of latitude / none", "bands", "no bands", None),
    ("still 1080p beyond POV-Ray / yardstick", "still", YARDSTICK, "povray"),
    ("explore / yardstick", "explore", YARDSTICK, None),
    ("night with Danjon's airs / yardstick", "night", YARDSTICK, None),
    ("tradeoff --quick / yardstick", "tradeoff", YARDSTICK, None),
]


def processor_seconds(command, folder):
    """Of the process and of all its children that it waited for."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: {errors.decode()}")
    return usage.ru_utime + usage.ru_stime


def window_of_still(scratch, command):
    """The arguments by which `still` has POV-Ray render a part of the frame: what a program in its place is given."""
    place = scratch / "bin"
    place.mkdir()
    povray = place / "povray"
    povray.write_text(f'#!/bin/sh\necho "$@" >"{scratch}/words"\nexec {shutil.which("povray")} "$@"\n')
    povray.chmod(0o755)
    subprocess.run(command, cwd=scratch, check=True, capture_output=True,
                   env=os.environ | {"PATH": f"{place}:{os.environ['PATH']}"})
    words = (scratch / "words").read_text().split()
    return [word for word in words if word[:3] in ("+SC", "+SR", "+EC", "+ER")]


def ratios(rounds):
    """Lists of ratios by name, one ratio a round."""
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        commands = {name: text.split() for name, text in COMMANDS.items()}
        for command in commands.values():
            if command[0] == "coppermoon":
                command[0] = str(RELEASE / "coppermoon")
        subprocess.run(commands["bake"][:1] + f"scene {STILL} -o scene".split(), cwd=scratch, check=True,
                       capture_output=True)
        commands["povray"] += window_of_still(scratch, commands["still"])
        taken = {name: [] for name in commands}
        for _ in range(rounds):
            for name, command in commands.items():
                if sum(taken[name]) < ENOUGH_S:
                    taken[name].append(processor_seconds(command, scratch / ("scene" if name == "povray" else "")))
    found = {name: [(one - less) / over for one, over, less in
                    zip(taken[what], taken[partner], taken[first] if first else [0] * rounds)]
             for name, what, partner, first in RATIOS}
    return found, taken[YARDSTICK]


def google_benchmarks(program, rounds):
    """Lists of times by name, in milliseconds of all processors."""
    text = subprocess.run([RELEASE / "tests" / "benchmarks" / program, "--benchmark_format=json",
                           "--benchmark_min_time=0.05", f"--benchmark_repetitions={rounds}",
                           "--benchmark_enable_random_interleaving=true"], check=True, capture_output=True).stdout
    found = {}
    for run in json.loads(text)["benchmarks"]:
        if run["run_type"] == "iteration":
            name = run["run_name"].replace("/process_time", "").replace("/real_time", "")
            found.setdefault(name, []).append(run["cpu_time"] * {"ns": 1e-6, "us": 1e-3, "ms": 1}[run["time_unit"]])
    return dict(sorted(found.items()))


def measured(rounds):
    """Rows of name, median, least, largest and unit."""
    ratio, yardstick = ratios(rounds)
    kernels = google_benchmarks("coppermoon_benchmarks", min(rounds, 3))
    bake = google_benchmarks("coppermoon_bake_benchmark", rounds)
    alone = bake.pop("write_by_openimageio_alone")
    ratio["texture: bake and write / OpenImageIO alone"] = [a / b for a, b in zip(bake.pop("bake_and_write"), alone)]
    kernels |= bake
    rows = []
    for unit, figures in (("ratio", ratio), ("s", {YARDSTICK: yardstick}), ("ms", kernels)):
        rows += [[name, statistics.median(values), min(values), max(values), unit] for name, values in figures.items()]
    return rows


def compare(before, now):
    """Prints rows beside those of the commit before, times as the yardstick's: name → [median, least, largest, unit]."""
    speed = now[YARDSTICK][0] / before[YARDSTICK][0] if YARDSTICK in before else 1
    losses = 0
    for name, (median, least, largest, unit) in now.items():
        line = f"{name:50} {median:9.4g} {unit:5} ({least:.4g} to {largest:.4g})"
        if name in before and name != YARDSTICK:
            median_then, _, largest_then, _ = before[name]
            factor = 1 if unit == "ratio" else speed
            change = median / (median_then * factor) - 1
            lost = change > 0.1 and least > largest_then * factor
            losses += lost
            line += f"  {100 * change:+.0f} %" + ("  SLOWER" if lost else "")
        print(line)
    if before:
        print(f"{losses} slower by more than a tenth")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path(__file__).with_name("history.csv"))
    options = parser.parse_args()
    subprocess.run([ROOT / "examples" / "build.sh", "coppermoon_program coppermoon_benchmarks coppermoon_bake_benchmark",
                    "packages.tests.debian"], check=True, stdout=sys.stderr)
    begun = time.monotonic()
    commit = subprocess.run([ROOT / "examples" / "made_at.sh", "--commit"], check=True, capture_output=True,
                            text=True).stdout.strip()
    kept = []
    if options.into.exists():
        with options.into.open(newline="") as file:
            kept = list(csv.DictReader(file))
    others = [row["commit"] for row in kept if row["commit"] != commit]
    before = {row["name"]: [float(row["median"]), float(row["least"]), float(row["largest"]), row["unit"]]
              for row in kept if others and row["commit"] == others[-1]}
    rows = measured(options.rounds)
    date = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d")
    with options.into.open("a", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        if not kept:
            writer.writerow(HEAD)
        for name, *values, unit in rows:
            writer.writerow([commit, date, name, *(f"{value:.4g}" for value in values), unit])
    compare(before, {name: values for name, *values in rows})
    print(f"{commit}, after {others[-1] if others else 'none'}: {time.monotonic() - begun:.0f} s")


if __name__ == "__main__":
    main()

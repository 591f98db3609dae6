# SPDX-License-Identifier: MIT
"""The program coppermoon in the background: its output, progress and errors."""
import os
import re
import subprocess

from . import preferences
from .wrong import Wrong

BAR = re.compile(r"(\w+) +\[[= ]*\] +(\d+) %")  # as "light        [=====     ]  17 %"
ESCAPES = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


class Stream:
    """Text from a file descriptor, as far as it has come."""

    def __init__(self, descriptor):
        self.descriptor = descriptor
        self.text = ""
        os.set_blocking(descriptor, False)

    def read(self):
        """Reads what has come."""
        try:
            while some := os.read(self.descriptor, 65536):
                self.text += some.decode("utf-8", "replace")
        except OSError:  # nothing yet; or the terminal's end
            pass

    def lines(self):
        """Whole lines that have come, each once."""
        *whole, self.text = re.split(r"[\r\n]+", self.text)
        return [line for line in (ESCAPES.sub("", line).strip() for line in whole) if line]


def run(words, take=lambda line: None):
    """Runs the program, step by step: yields (what, part done) several times a second of the caller's, and returns the
    lines of stdout. Closing the generator ends the program.

    Given   take  called with each line as it comes
    Throws  Wrong  with the program's last word, where it fails
    """
    path = preferences.program()
    ours, theirs = os.openpty()  # it draws its bar on a terminal alone
    try:
        process = subprocess.Popen([path, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=theirs)
    except OSError as error:
        os.close(ours)
        raise Wrong(f"{path}: {error.strerror}") from error
    finally:
        os.close(theirs)
    out, errors = Stream(process.stdout.fileno()), Stream(ours)
    progress, said, lines = ("start", 0.0), "", []
    try:
        while True:
            ended = process.poll() is not None
            out.read()
            errors.read()
            for line in out.lines():
                take(line)
                lines.append(line)
            bars = BAR.findall(errors.text)
            if bars:
                progress = (bars[-1][0], int(bars[-1][1]) / 100)
            for line in errors.lines():
                if line.startswith("coppermoon: "):
                    said = line.removeprefix("coppermoon: ")
            if ended:
                break
            yield progress
    finally:
        if process.poll() is None:
            process.terminate()
            process.wait()
        process.stdout.close()
        os.close(ours)
    if process.returncode != 0:
        raise Wrong(said or f"{path}: ended with status {process.returncode}")
    return lines

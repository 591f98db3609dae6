# SPDX-License-Identifier: MIT
"""Runs the program coppermoon in the background, and reads its output, progress and errors."""
import os
import queue
import re
import subprocess
import threading

from . import preferences
from .wrong import Wrong

BAR = re.compile(r"(\w+) +\[[= ]*\] +(\d+) %")  # such as "light        [=====     ]  17 %"
ESCAPES = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


class Stream:
    """Collects text from a file descriptor. A thread waits for the text, because reading a pipe on Windows blocks."""

    def __init__(self, descriptor):
        self.text = ""
        self.arrived = queue.SimpleQueue()
        self.thread = threading.Thread(target=self.wait, args=(descriptor,), daemon=True)
        self.thread.start()

    def wait(self, descriptor):
        try:
            while some := os.read(descriptor, 65536):
                self.arrived.put(some.decode("utf-8", "replace"))
        except OSError:  # the terminal has closed
            pass

    def read(self):
        """Appends the text that has arrived so far to `self.text`."""
        while not self.arrived.empty():
            self.text += self.arrived.get()

    def lines(self):
        """Removes the complete lines from `self.text`, and returns them."""
        *whole, self.text = re.split(r"[\r\n]+", self.text)
        return [line for line in (ESCAPES.sub("", line).strip() for line in whole) if line]


def run(words, take=lambda line: None):
    """Runs the program. Yields (step, fraction done) each time the caller asks, which should be several times a second,
    and finally returns the lines from stdout. Closing the generator ends the program.

    Given   take  function that is called with each line from stdout as it arrives
    Throws  Wrong  with the program's last error message, if the program fails
    """
    path = preferences.program()
    # The program draws its progress bar only on a terminal, which cannot be created easily on Windows.
    ours, theirs = os.openpty() if hasattr(os, "openpty") else os.pipe()
    try:
        process = subprocess.Popen([path, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=theirs,
                                   creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))
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
            if ended:
                out.thread.join(1)
                errors.thread.join(1)
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
        out.thread.join(1)
        errors.thread.join(1)
        process.stdout.close()
        os.close(ours)
    if process.returncode != 0:
        raise Wrong(said or f"{path}: ended with status {process.returncode}")
    return lines

# SPDX-License-Identifier: MIT
"""Mutations of C++ sources: python3 mutations.py SEED COUNT INTO FOLDER …

Draws COUNT places at random from the folders' own sources (*.cpp), but for those whose own tests are HEAVY, and writes each
mutated source, INTO/1, INTO/2, …
Prints a line of each: its file, and what is other. One operator or one number is: + and −, · and /, && and || trade places,
also with =; comparisons are turned round; min and max trade places; a number is doubled, and 0 becomes 1.
"""
import pathlib
import random
import re
import sys

pairs = [("+", "-"), ("*", "/"), ("&&", "||"), ("<", ">"), ("<=", ">="), ("==", "!="), ("+=", "-="), ("*=", "/="), ("min", "max")]
other = {a: b for pair in pairs for a, b in (pair, pair[::-1])}

# Comments, texts and lines of the preprocessor are passed over; binary operators have spaces around them, by clang-format.
token = re.compile(
    r"""//[^\n]* | ^\#[^\n]* | R"(?P<mark>\w*)\(.*?\)(?P=mark)" | "(?:\\.|[^"\\])*" | (?<!\d)'(?:\\.|[^'\\])'
    | (?<=\ )(?P<operator>[-+*/]=?|&&|\|\||[<>]=?|[=!]=)(?=[ \n])
    | (?<=std::)(?P<function>min|max)(?=\()
    | (?<![\w.'])(?P<number>\d[\d']*(?:\.\d+)?(?:[eE][-+]?\d+)?)(?=[FfUu]?(?![\w.']))""",
    re.VERBOSE | re.MULTILINE | re.DOTALL)


def doubled(number):
    if re.fullmatch(r"[\d']+", number):
        return str(2 * int(number.replace("'", "")) or 1)
    return repr(2 * float(number.replace("'", "")) or 1.0)


def places_in(source):
    """Places of a text that may change: begin, end, and what comes there."""
    for found in token.finditer(source):
        if sign := found["operator"] or found["function"]:
            yield found.start(), found.end(), other[sign]
        elif found["number"]:
            yield found.start(), found.end(), doubled(found["number"])


def heavily_tested(folder):
    kinds = re.split(r"\b(QUICK|HEAVY|SLOW|LINKS)\b", pathlib.Path("tests", folder, "tests.cmake").read_text())
    return re.findall(r"\w+", " ".join(words for kind, words in zip(kinds, kinds[1:]) if kind == "HEAVY"))


seed, count, into, *folders = sys.argv[1:]
files = sorted(file for folder in folders for file in pathlib.Path(folder).glob("*.cpp")
               if file.stem not in heavily_tested(folder))
places = [(file, *place) for file in files for place in places_in(file.read_text())]
draw = random.Random(int(seed)).sample(places, min(int(count), len(places)))
for number, (file, begin, end, new) in enumerate(draw, 1):
    source = file.read_text()
    pathlib.Path(into, str(number)).write_text(source[:begin] + new + source[end:])
    line = source.count("\n", 0, begin) + 1
    print(f"{file}\t{line}: {source[begin:end]} => {new}\t{source.splitlines()[line - 1].strip()}")

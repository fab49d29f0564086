#!/usr/bin/env python3
"""Checks text that no compiler reads: left-over markers, dead code, paths of one person's machine, and that the C++ in
README.md is that of an example, which a test compiles and runs.

usage: check_words.py [ROOT]

Prints one line a finding, and exits with 1 where there is any.
"""

import os
import re
import sys

CODE = (".hpp", ".cpp", ".glsl", ".def", ".py", ".cmake")
TEXT = CODE + (".md", ".txt", ".json", ".toml", ".yml")

# Each rule: the files it holds for, what it looks for, and what to do instead.
RULES = [
    (CODE, re.compile(r"\b(TODO|FIXME|XXX|HACK)\b"), "finish it, or describe the limit in docs/"),
    (CODE, re.compile(r"^\s*#\s*if\s+0\b"), "remove dead code; history keeps it"),
    (TEXT, re.compile(r"(?<![\w.~}])/(home/(?!somebody)|root/|work/|Users/)\w"), "a path of one machine; use a relative one"),
    (TEXT, re.compile(r"[ \t]+$"), "trailing white space"),
]
EXEMPT = {"tools/check_words.py"}   # its rules name what they forbid
SKIPPED_FOLDERS = {"build", ".git", ".cache"}
SKIPPED_PATHS = ("tests/data/", "tests/golden/")   # inputs and pictures, not prose


def text_files(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(set(folders) - SKIPPED_FOLDERS)
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")
            if name.endswith(TEXT) and path not in EXEMPT and not path.startswith(SKIPPED_PATHS):
                yield path


def findings(root):
    for path in text_files(root):
        with open(os.path.join(root, path), encoding="utf-8") as file:
            for number, line in enumerate(file.read().split("\n"), 1):
                for endings, pattern, advice in RULES:
                    if path.endswith(endings) and pattern.search(line):
                        yield f"{path}:{number}: {pattern.search(line).group().strip() or 'white space'}: {advice}"


def untested_examples(root):
    """C++ in README.md that stands in no file of examples/."""
    examples = ""
    for folder, _, names in os.walk(os.path.join(root, "examples")):
        for name in names:
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                examples += file.read()
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        for block in re.findall(r"```cpp\n(.*?)```", file.read(), re.DOTALL):
            if block not in examples:
                yield "README.md: C++ that is in no file of examples/:\n" + block


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    lines = [*findings(root), *untested_examples(root)]
    for line in lines:
        print(line)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Checks that C++ is laid out as clang-format does it by the file .clang-format; shaders and tables of macros are laid out
by hand.

usage: check_format.py [ROOT]

Prints one line a file that is not, and exits with 1 where there is any.
"""

import os
import subprocess
import sys

FOLDERS = ("apps", "bench", "examples", "include", "scenes", "src", "tests")
CODE = (".hpp", ".cpp")


def code_files(root):
    for top in FOLDERS:
        for folder, _, names in os.walk(os.path.join(root, top)):
            yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith(CODE))


def is_formatted(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    result = subprocess.run(["clang-format", f"--assume-filename={path}"], input=text, capture_output=True, text=True,
                            check=True)
    return result.stdout == text


def check(root):
    return [f"{os.path.relpath(path, root)}: not laid out by clang-format; run clang-format -i on it"
            for path in code_files(root) if not is_formatted(path)]


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    try:
        found = check(os.path.normpath(root))
    except FileNotFoundError:
        sys.exit("clang-format is not installed")
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()

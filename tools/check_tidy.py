#!/usr/bin/env python3
"""Checks src and scenes by clang-tidy, with the list of checks in .clang-tidy.

usage: check_tidy.py [ROOT]

Takes compile commands from build/release, which must have been configured and built: generated headers are among what the
sources include. Precompiled headers are left out, which g++ writes and clang cannot read. Reading headers takes most of
clang-tidy's time, so neighbouring files are checked as one unit, as far as they can be compiled together. Prints the findings,
and exits with 1 where there is any. ./run tidy does all of that.
"""

import collections
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

FOLDERS = ("scenes", "src")
FINDING = re.compile(r"^/.*:\d+:\d+: (?:warning|error|fatal error): ", re.MULTILINE)
# Files a unit: enough that headers count little, few enough that the last unit does not run alone for long.
UNIT_FILES = 12
# A constant, a type or a function at the start of a line.
DECLARATION = re.compile(r"^(?!using|namespace|template|return)[A-Za-z][\w:<>,&* ]*?[ &*](\w+)(?: =|[({\[;]| \{| :|$)",
                         re.MULTILINE)
Unit = collections.namedtuple("Unit", "flags files names")


def sources(root):
    for top in FOLDERS:
        for folder, _, names in os.walk(os.path.join(root, top)):
            yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith(".cpp"))


def flags_of(entry):
    """The words of a compile command without its file, its output and precompiled headers."""
    words, kept = iter(shlex.split(entry["command"])), []
    for word in words:
        if word in ("-o", "-c"):
            next(words)
        elif word.endswith("cmake_pch.hxx"):
            kept.pop()  # -include
        elif word not in ("-Winvalid-pch", entry["file"]):
            kept.append(word)
    return tuple(kept)


def flags_by_file(build):
    """Files that CMake compiles as one unit have that unit's flags."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    flags = {}
    for entry in entries:
        files = [entry["file"]]
        if "/Unity/" in entry["file"]:
            with open(entry["file"], encoding="utf-8") as file:
                files = re.findall(r'^#include "(.*)"', file.read(), re.MULTILINE)
        flags.update(dict.fromkeys(files, flags_of(entry)))
    return flags


def names_of(path):
    """Names that a file may declare for itself, with its folder, whose namespace they are in."""
    with open(path, encoding="utf-8") as file:
        return {(os.path.dirname(path), name) for name in DECLARATION.findall(file.read())}


def units(paths, flags):
    """Lists of files with equal flags and no common names."""
    found = []
    for path in paths:
        names = names_of(path)
        for unit in found:
            if unit.flags == flags[path] and len(unit.files) < UNIT_FILES and not unit.names & names:
                break
        else:
            unit = Unit(flags[path], [], set())
            found.append(unit)
        unit.files.append(path)
        unit.names.update(names)
    return [unit.files for unit in found]


class Checker:
    def __init__(self, root, flags):
        self.build, self.folder, self.flags = os.path.join(root, "build/release"), os.path.join(root, "build/tidy"), flags
        os.makedirs(self.folder, exist_ok=True)

    def run(self, path, flags):
        command = ["clang-tidy", "-quiet", path, "--", *flags[1:], f"-working-directory={self.build}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        starts = [match.start() for match in FINDING.finditer(done.stdout)]
        found = [done.stdout[start:end] for start, end in zip(starts, [*starts[1:], None])]
        return found if found or done.returncode == 0 else [f"{path}: clang-tidy fails\n{done.stderr}"]

    def check_unit(self, name, files):
        """Two files of a unit may use one name for two things: the one with the error goes into a unit of its own then."""
        if len(files) == 1:
            return self.run(files[0], self.flags[files[0]])
        unit = os.path.join(self.folder, f"{name}.cpp")
        with open(unit, "w", encoding="utf-8") as out:
            out.writelines(f'#include "{path}"\n' for path in files)
        found = self.run(unit, self.flags[files[0]])
        errors = tuple(finding for finding in found if "[clang-diagnostic-error]" in finding)
        if not errors:
            return found
        later = [path for path in files if any(error.startswith(path + ":") for error in errors)] or files[1:]
        sooner = [path for path in files if path not in later] or [later.pop(0)]
        return [*self.check_unit(name + "_a", sooner), *self.check_unit(name + "_b", later)]

    def check(self, paths):
        """Yields the findings of each unit."""
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            longest_first = sorted(units(paths, self.flags), key=len, reverse=True)
            work = [pool.submit(self.check_unit, f"unit_{number}", unit) for number, unit in enumerate(longest_first)]
            for count, job in enumerate(concurrent.futures.as_completed(work), 1):
                report_progress(count, len(work))
                yield job.result()


def report_progress(count, total):
    if sys.stderr.isatty():
        end = "\r\033[K" if count == total else ""
        print(f"\rvelarium: clang-tidy {count}/{total} ", end=end, file=sys.stderr, flush=True)
    elif count == total:
        print(f"velarium: clang-tidy {count}/{total}", file=sys.stderr, flush=True)


def check(root):
    flags = flags_by_file(os.path.join(root, "build/release"))
    paths = list(sources(root))
    unknown = [f"{path}: no compile command\n" for path in paths if path not in flags]
    found = {finding for findings in Checker(root, flags).check([path for path in paths if path in flags])
             for finding in findings}  # a header's, once
    return sorted(finding.replace(root + "/", "") for finding in [*unknown, *found])


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    try:
        found = check(os.path.abspath(root))
    except FileNotFoundError as error:
        sys.exit(f"{error.filename} is missing; ./run tidy installs and builds what this needs")
    print("".join(found), end="")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Accepts pictures that the golden test has drawn: copies them to tests/golden, and notes what drew them.

usage: accept.py [--from FOLDER] [NAME...]

Look at the pictures first. NAME: a row of tests/golden/golden_test.cpp; none: every picture that was drawn.
--from: the folder `golden` of a build tree (default: that of the latest run below build/).
"""

import argparse
import datetime
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GOLDENS = ROOT / "tests" / "golden"
RECORD = GOLDENS / "ACCEPTED.json"


def latest_results():
    runs = list(ROOT.glob("build/*/tests/golden/actual/device.json"))
    if not runs:
        sys.exit("accept.py: no build tree holds pictures; run the golden test by ctest, or name a folder by --from")
    return max(runs, key=lambda file: file.stat().st_mtime).parent.parent


def commit():
    """The commit that is checked out, marked where sources differ from it."""

    def git(*words):
        return subprocess.run(["git", "-C", str(ROOT), *words], check=True, capture_output=True, text=True).stdout.strip()

    changed = git("status", "--porcelain", "--untracked-files=no", "--", "src", "scenes", "include", "tests/data")
    return git("rev-parse", "--short=12", "HEAD") + ("-modified" if changed else "")


def chosen(actual, names):
    drawn = {file.stem: file for file in actual.glob("*.png")}
    for name in names:
        if name not in drawn:
            sys.exit(f"accept.py: {actual} holds no picture '{name}'; there are {', '.join(sorted(drawn))}")
    return {name: drawn[name] for name in sorted(names or drawn)}


def accept(actual, names):
    """Copies pictures whose bytes differ from the accepted ones; the record of the others stays as it is."""
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    device = json.loads((actual / "device.json").read_text())
    note = {"commit": commit(), **device, "date": datetime.date.today().isoformat()}
    for name, file in chosen(actual, names).items():
        golden = GOLDENS / f"{name}.png"
        if golden.exists() and golden.read_bytes() == file.read_bytes():
            continue
        print(f"{name}: {'changed' if golden.exists() else 'new'}")
        shutil.copyfile(file, golden)
        record[name] = note
    record = {name: record[name] for name in sorted(record) if (GOLDENS / f"{name}.png").exists()}
    RECORD.write_text(json.dumps(record, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--from", dest="results", type=pathlib.Path, metavar="FOLDER")
    options = parser.parse_args()
    accept((options.results or latest_results()) / "actual", options.names)


if __name__ == "__main__":
    main()

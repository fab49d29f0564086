#!/usr/bin/env python3
"""Carries over what the convergence test has measured: lowers its budgets, and writes its part of docs/accuracy.md.

usage: convergence.py {lower,page} [--from FOLDER]

Run the test first. `lower` sets each budget to what was measured where that is less, and never raises one: that is an
edit by hand, with a sentence in the commit. `page` needs the results of every row. --from: the folder `convergence`
of a build tree (default: that of the latest run below build/).
"""

import argparse
import csv
import json
import math
import pathlib
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUDGETS = ROOT / "tests" / "convergence" / "budgets.csv"
NOISE = ROOT / "tests" / "convergence" / "references.csv"
PAGE = ROOT / "docs" / "accuracy.md"
PICTURES = ROOT / "docs" / "images" / "accuracy"
BEGIN = "<!-- written by tools/convergence.py page: begin -->\n"
END = "<!-- written by tools/convergence.py page: end -->\n"
METRICS = ("flip", "relmse")


def latest_results():
    runs = list(ROOT.glob("build/*/tests/convergence/*.json"))
    if not runs:
        sys.exit("convergence.py: no build tree holds results; run the test convergence by ctest, or name a folder by --from")
    return max(runs, key=lambda file: file.stat().st_mtime).parent


def read_table(file):
    with open(file, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def measured(folder, name):
    file = folder / f"{name}.json"
    return json.loads(file.read_text()) if file.exists() else None


def rounded_up(value):
    """To two digits."""
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f"{math.ceil(value / step) * step:.2g}")


def lower(folder):
    rows = read_table(BUDGETS)
    for row in rows:
        found = measured(folder, row["name"])
        if found is None:
            print(f"{row['name']}: not measured, budget kept")
            continue
        for metric in METRICS:
            budget = rounded_up(found[metric])
            if budget < float(row[metric]):
                print(f"{row['name']}: {metric} {row[metric]} -> {budget:g}")
                row[metric] = f"{budget:g}"
    with open(BUDGETS, "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def described(row):
    """What was drawn, in the words of the command line."""
    words = [row["scene"].removeprefix("assets:").split("/")[-1]]
    if row["environment"]:
        words.append("--env " + row["environment"].removeprefix("assets:").split("/")[-1])
    words += [f"-D {setting}" for setting in row["settings"].split()]
    against = "--transport " + row["transport"].replace("direct_env", "direct+env")
    return f"`{' '.join(words)}` against `{against}{' --shadows off' if row['shadows'] == 'off' else ''}`"


def section(row, found, noise):
    error = f"FLIP {found['flip']:.3g}, relative MSE {found['relmse']:.2g}"
    spread = f"noise of the reference {float(noise['flip']):.2g} and {float(noise['relmse']):.2g} at {noise['paths']} paths a pixel"
    return (f"**{row['name']}** · {described(row)}\n\n![Velarium, reference, error](images/accuracy/{row['name']}.jpg)\n\n"
            f"{error}; {spread}. What is left: {row['cause']}.\n\n")


def write_page(folder):
    noise = {row["name"]: row for row in read_table(NOISE)}
    text = ""
    for row in read_table(BUDGETS):
        found = measured(folder, row["name"])
        if found is None:
            sys.exit(f"convergence.py: {folder} has no results of '{row['name']}'; set VELARIUM_ASSETS and run the test")
        text += section(row, found, noise[row["reference"]])
        PICTURES.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(folder / f"{row['name']}.jpg", PICTURES / f"{row['name']}.jpg")
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.index(BEGIN) + len(BEGIN), page.index(END)
    PAGE.write_text(page[:before] + "\n" + text + page[after:], encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verb", choices=("lower", "page"))
    parser.add_argument("--from", dest="results", type=pathlib.Path, metavar="FOLDER")
    options = parser.parse_args()
    folder = options.results or latest_results()
    lower(folder) if options.verb == "lower" else write_page(folder)


if __name__ == "__main__":
    main()

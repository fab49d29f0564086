#!/usr/bin/env python3
"""Renders the Khronos glTF Render Fidelity scenarios, for a scorer to compare.

  fidelity.py SCENARIOS.json OUT_DIR [--velarium BINARY] [--only REGEX] [-- more options for `velarium render`]

SCENARIOS.json lists models (relative to `assets_root`), environments, cameras and sizes. Each picture is made at
twice the listed size, tone-mapped with the ACES curve at exposure 0, without dither, and written to
OUT_DIR/<name>.png.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys


def command(binary, scenario, folder, assets, out):
    camera = scenario["camera"]
    vector = lambda v: ",".join(repr(float(x)) for x in v)
    background = "env" if scenario["background"] == "skybox" else "transparent"
    return [
        binary, "render", str(assets / scenario["model"]), "-o", str(out / (scenario["name"] + ".png")),
        "--size", f"{2 * scenario['width']}x{2 * scenario['height']}",
        "--eye", vector(camera["eye"]), "--target", vector(camera["target"]), "--up", vector(camera["up"]),
        "--fov", repr(camera["vertical_fov_deg"]), "--env", str(folder / scenario["environment"]),
        "--tonemap", "aces", "--exposure", "0", "--background", background, "--animation", "none",
        "-D", "display.dither=off", "-q",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenarios", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--velarium", default=str(pathlib.Path(__file__).parent.parent / "build/release/velarium"))
    parser.add_argument("--only", default="")
    args, more = parser.parse_known_args()
    document = json.loads(args.scenarios.read_text())
    folder = args.scenarios.parent
    assets = (folder / document["assets_root"].split("<")[0]).resolve()
    args.out.mkdir(parents=True, exist_ok=True)
    failed = 0
    for scenario in document["scenarios"]:
        if not re.search(args.only, scenario["name"]):
            continue
        result = subprocess.run(command(args.velarium, scenario, folder, assets, args.out) + [m for m in more if m != "--"])
        if result.returncode != 0:
            print(f"{scenario['name']}: exit {result.returncode}", file=sys.stderr)
            failed += 1
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

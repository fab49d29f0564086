#!/usr/bin/env python3
"""Checks that each folder includes only what the architecture lets it see (docs/architecture.md).

usage: check_includes.py [ROOT]

Reads every C++ and GLSL file under include, src, apps, scenes and examples. Prints one line a forbidden include,
and exits with 1 where there is any.
"""

import os
import re
import sys

# What a folder may see besides itself, the public headers and the standard library.
MAY_SEE = {
    "core": set(),
    "shading": set(),
    "image": {"core"},
    "scene": {"image", "core"},
    "gpu": {"shading", "core"},
    "graph": {"gpu", "core"},
    "upload": {"scene", "gpu", "shading", "core"},
    "passes": {"graph", "upload", "gpu", "shading", "core"},
    "bake": {"graph", "gpu", "shading", "image", "core"},
    "frame": {"passes", "bake", "upload", "graph", "gpu", "scene", "image", "shading", "core"},
    "reference": {"scene", "shading", "image", "core"},
    "api": {"frame", "reference", "passes", "bake", "upload", "graph", "gpu", "scene", "image", "shading", "core"},
    "apps": set(),
    "examples": set(),
    "public": set(),
}

# Of another technique a pass sees what is made to be read: its `read*` and its `*_io` files. Everyone reads the
# G-buffer; the others are for the hub and for the passes that shade points.
READ = re.compile(r"(read[a-z_]*|[a-z_]*_io)\.[a-z.]+$")
SHADING_PASSES = {"lighting", "forward", "light_volumes", "sun_shadow_mask"}
HUB = re.compile(r"src/passes/illumination\.(hpp|cpp|glsl)$")

SEES_VULKAN = {"gpu"} | {folder for folder, seen in MAY_SEE.items() if "gpu" in seen}

# Libraries that are walled in: an include that starts with the key is for these folders alone.
LIBRARIES = {
    "vulkan/": SEES_VULKAN,
    "volk.h": SEES_VULKAN,
    "png.h": {"image"},
    "turbojpeg.h": {"image"},
    "webp/": {"image"},
    "OpenEXR/": {"image"},
    "Imath/": {"image"},
    "Imf": {"image"},
    "meshoptimizer.h": {"scene"},
    "draco/": {"scene"},
    "nlohmann/": {"scene", "apps"},
    "toml++/": {"apps"},
    "CLI/": {"apps"},
    "embree3/": {"reference"},
    "fmt/": set(MAY_SEE) - {"public", "shading", "examples"},
    "glm/": set(MAY_SEE) - {"public", "core", "apps", "examples"},
}

SOURCES = (".hpp", ".cpp", ".glsl", ".def", ".inc")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)


def owner(path):
    """The folder of the table that a path inside the repository belongs to, and the pass where it is of one."""
    parts = path.split("/")
    if parts[0] == "src" and len(parts) > 2:
        return parts[1], parts[2] if parts[1] == "passes" and len(parts) > 3 else None
    top = {"include": "public", "apps": "apps", "scenes": "scene", "examples": "examples"}
    return top.get(parts[0]), None


def resolve(root, path, quote, name):
    """The repository path that an include means, or None where it is not of this repository."""
    places = [os.path.dirname(path)] if quote == '"' else []
    for place in places + ["src", "include", "."]:
        target = os.path.normpath(os.path.join(place, name))
        if os.path.isfile(os.path.join(root, target)):
            return target
    return None


def refused_pass(path, own_pass, target, other_pass):
    """Why a file of src/passes may not include another one, or None where it may."""
    if other_pass is None or own_pass == other_pass:
        return None
    if not READ.search(target):
        return "of another technique a pass sees read* and *_io files alone"
    reads_all = HUB.search(path) or own_pass in SHADING_PASSES
    if other_pass != "gbuffer" and not reads_all:
        return "illumination.* and passes that shade are the readers of other techniques"
    return None


def refusal(root, path, quote, name):
    """Why `path` may not include `name`, or None where it may."""
    folder, own_pass = owner(path)
    target = resolve(root, path, quote, name)
    if target is None:
        for prefix, allowed in LIBRARIES.items():
            if name.startswith(prefix) and folder not in allowed:
                return f"{prefix} is for {', '.join(sorted(allowed))} only"
        if folder == "public" and ("/" in name or "." in name):
            return "public headers include the standard library and each other only"
        return None
    seen, other_pass = owner(target)
    if folder == "gpu" and seen == "shading" and not target.endswith("/lang.glsl"):
        return "gpu sees lang.glsl of shading alone"
    if seen in (folder, "public"):
        return refused_pass(path, own_pass, target, other_pass)
    if seen not in MAY_SEE[folder]:
        return f"{folder} may see {', '.join(sorted(MAY_SEE[folder])) or 'the public headers only'}"
    return None


def source_files(root):
    for top in ("include", "src", "apps", "scenes", "examples"):
        for folder, _, names in sorted(os.walk(os.path.join(root, top))):
            for name in sorted(names):
                if name.endswith(SOURCES):
                    yield os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")


def check(root):
    """All complaints, one string each."""
    complaints = []
    for path in source_files(root):
        if owner(path)[0] not in MAY_SEE:
            complaints.append(f"{path}:1: the folder is not in the table of tools/check_includes.py")
            continue
        with open(os.path.join(root, path), encoding="utf-8") as file:
            text = file.read()
        for match in INCLUDE.finditer(text):
            reason = refusal(root, path, match.group(1), match.group(2))
            if reason:
                line = text.count("\n", 0, match.start()) + 1
                complaints.append(f"{path}:{line}: includes {match.group(2)}: {reason}")
    return complaints


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    complaints = check(root)
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())

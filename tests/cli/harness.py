"""Runs the shipped program and looks at what it leaves. Every test has an empty folder of its own."""

import base64
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

BINARY = os.environ.get("VELARIUM_BINARY", "velarium")

# Exit codes, as docs/rendering.md tells them.
OK, USAGE, MISSING, INVALID, UNSUPPORTED, NO_DEVICE, NOT_WRITTEN = 0, 2, 3, 4, 5, 6, 7
INTERRUPTED, TERMINATED = 130, 143

# Small enough for a software device, and wide enough that width and height cannot be confused.
SMALL = ["--size", "48x32", "--spp", "1"]


class CliTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="velarium-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments, env=None, **options):
        command = [BINARY, *map(str, arguments)]
        environment = {**os.environ, **(env or {})}
        return subprocess.Popen(command, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)

    def run_velarium(self, *arguments, env=None):
        process = self.start(*arguments, env=env)
        out, err = process.communicate(timeout=600)
        return process.returncode, out, err

    def expect(self, code, *arguments, says="", env=None):
        """Runs, checks the exit code, and that standard error contains `says`. Returns standard output."""
        got, out, err = self.run_velarium(*arguments, env=env)
        self.assertEqual(got, code, f"velarium {' '.join(map(str, arguments))}\n{out}{err}")
        self.assertIn(says, err)
        return out

    def render(self, *arguments, output="out.png"):
        """Renders a small picture and returns its path."""
        named = any(word.startswith("builtin:") or word.endswith((".gltf", ".glb")) for word in arguments)
        scene = [] if named else ["builtin:spheres"]  # which draws faster than the default scene
        self.expect(OK, "render", *scene, *SMALL, "-o", output, *arguments)
        return self.folder / output

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())


def needs_device(test):
    """Skips a test, or every test of a class, where no device can render."""
    listing = subprocess.run([BINARY, "devices", "--json"], capture_output=True, text=True, check=False)
    usable = listing.returncode == 0 and any(device["usable"] for device in json.loads(listing.stdout))
    return unittest.skipUnless(usable, "no Vulkan device that can render")(test)


TRIANGLE = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)


def data_uri(data):
    return "data:application/octet-stream;base64," + base64.b64encode(data).decode()


def triangle_gltf(**changes):
    """A glTF file of one triangle, with its buffer inside; `changes` replace top-level properties."""
    uri = data_uri(TRIANGLE)
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [-1, -1, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(TRIANGLE)}],
        "buffers": [{"uri": uri, "byteLength": len(TRIANGLE)}],
    }
    return json.dumps({**scene, **changes})


def read_png(path):
    """Width, height, channels and rows of an 8- or 16-bit PNG that is not interlaced; independent of libpng."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    position, body, header = 8, b"", None
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        chunk = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBB", chunk[:10])
        if kind == b"IDAT":
            body += chunk
        position += 12 + length
    width, height, bits, color = header
    channels = {2: 3, 6: 4}[color]
    return width, height, channels, unfilter(zlib.decompress(body), width * channels * bits // 8, channels * bits // 8)


def unfilter(raw, stride, step):
    """Undoes the five filters of PNG (W3C PNG, 9.2)."""
    rows, above = [], bytes(stride)
    for start in range(0, len(raw), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            row[i] = (row[i] + predicted(kind, left, above[i], corner)) & 255
        rows.append(bytes(row))
        above = row
    return rows


def predicted(kind, left, up, corner):
    if kind == 4:
        guess = left + up - corner
        return min((left, up, corner), key=lambda value: abs(guess - value))
    return [0, left, up, (left + up) // 2][kind]


def main():
    unittest.main(argv=[sys.argv[0], "-v"])

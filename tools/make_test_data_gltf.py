"""What make_test_data.py builds on: a writer of small glTF files, PNG pictures, and a few shapes.

Plain Python, nothing but the standard library. The same input gives the same bytes on every machine: numbers are
rounded to 32-bit floats before they are written, and PNG data is stored, not compressed.
"""

import base64
import json
import math
import struct
import zlib

FLOAT, U8, I8, U16, I16, U32 = 5126, 5121, 5120, 5123, 5122, 5125
_CODE = {FLOAT: "f", U8: "B", I8: "b", U16: "H", I16: "h", U32: "I"}
_VERTICES, _INDICES = 34962, 34963
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
POINTS, LINES, LINE_LOOP, LINE_STRIP, TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN = range(7)


def single(x):
    """x, as a 32-bit float holds it."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def flat(rows):
    return [x for row in rows for x in row] if rows and isinstance(rows[0], (list, tuple)) else list(rows)


# --- vectors and rotations ---------------------------------------------------------------------------------------


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def turn(axis, degrees):
    """The quaternion (x, y, z, w) of a turn about an axis."""
    half = math.radians(degrees) / 2
    return [math.sin(half) * x for x in unit(axis)] + [math.cos(half)]


def looking(eye, target, up=(0, 1, 0)):
    """The quaternion that turns -Z from eye to target. Shepperd's method for the branch that serves our views."""
    z = unit(sub(eye, target))
    x = unit(cross(up, z))
    y = cross(z, x)
    w = math.sqrt(max(0.0, 1 + x[0] + y[1] + z[2])) / 2
    assert w > 0.1, "the view is turned too far from -Z for this formula"
    return [(y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w), w]


# --- pictures ----------------------------------------------------------------------------------------------------


def png(width, height, pixel):
    """An RGBA picture; pixel(x, y) gives four values 0..255, y from the top."""

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    stored = b"\x78\x01" + b"\x01" + struct.pack("<HH", len(rows), 0xFFFF ^ len(rows)) + rows
    stored += struct.pack(">I", zlib.adler32(rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", stored) + chunk(b"IEND", b"")


# --- the file ----------------------------------------------------------------------------------------------------


class Gltf:
    def __init__(self):
        self.bin = bytearray()
        self.more_buffers = []  # after the one that holds the data
        self.root = {
            "asset": {"version": "2.0", "generator": "Velarium test data", "copyright": "CC0 1.0, the Velarium authors"},
            "scene": 0,
            "scenes": [{"nodes": []}],
        }

    def add(self, table, item):
        self.root.setdefault(table, []).append(item)
        return len(self.root[table]) - 1

    def extension(self, name, required=False):
        for key in ["extensionsUsed"] + ["extensionsRequired"] * required:
            if name not in self.root.setdefault(key, []):
                self.root[key].append(name)
        return self

    def view(self, data, **more):
        self.bin += b"\0" * (-len(self.bin) % 4)
        offset = len(self.bin)
        self.bin += data
        return self.add("bufferViews", {"buffer": 0, "byteOffset": offset, "byteLength": len(data), **more})

    def accessor(self, rows, kind, component=FLOAT, normalized=False, bounds=False, stride=0, target=None):
        """stride: bytes from row to row, where rows need padding (attributes are 4-byte aligned)."""
        width = _WIDTH[kind]
        values = flat(rows)
        code = f"<{width}{_CODE[component]}"
        packed = [struct.pack(code, *values[i : i + width]) for i in range(0, len(values), width)]
        more = {"byteStride": stride} if stride else {}
        if target:
            more["target"] = target
        data = b"".join(p.ljust(stride, b"\0") for p in packed)
        item = {
            "bufferView": self.view(data, **more),
            "componentType": component,
            "count": len(packed),
            "type": kind,
        }
        if normalized:
            item["normalized"] = True
        if bounds:
            exact = [struct.unpack(code, p) for p in packed]
            item["min"] = [min(column) for column in zip(*exact)]
            item["max"] = [max(column) for column in zip(*exact)]
        return self.add("accessors", item)

    def attribute(self, rows, kind, component=FLOAT, **more):
        return self.accessor(rows, kind, component, target=_VERTICES, **more)

    def indices(self, values):
        return self.accessor(values, "SCALAR", U16, target=_INDICES)

    def primitive(self, positions, normals=None, uv=None, indices=None, material=None, colors=None, mode=TRIANGLES):
        """uv is left out where the material has no texture."""
        attributes = {"POSITION": self.attribute(positions, "VEC3", bounds=True)}
        if normals:
            attributes["NORMAL"] = self.attribute(normals, "VEC3")
        if uv and material is not None and "Texture" in json.dumps(self.root["materials"][material]):
            attributes["TEXCOORD_0"] = self.attribute(uv, "VEC2")
        if colors:
            attributes["COLOR_0"] = self.attribute(colors, "VEC4", U8, normalized=True)
        out = {"attributes": attributes}
        if indices:
            out["indices"] = self.indices(indices)
        if material is not None:
            out["material"] = material
        if mode != TRIANGLES:
            out["mode"] = mode
        return out

    def mesh(self, *primitives, **more):
        return self.add("meshes", {"primitives": list(primitives), **more})

    def node(self, root=True, **fields):
        for key in ("translation", "rotation", "scale"):
            if key in fields:
                fields[key] = [single(x) for x in fields[key]]
        index = self.add("nodes", fields)
        if root:
            self.root["scenes"][0]["nodes"].append(index)
        return index

    def material(self, color=(1, 1, 1, 1), metallic=0.0, roughness=0.5, texture=None, extensions=None, **more):
        pbr = {"baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            pbr["baseColorTexture"] = texture if isinstance(texture, dict) else {"index": texture}
        out = {"pbrMetallicRoughness": pbr, **more}
        if extensions:
            for name in extensions:
                self.extension(name)
            out["extensions"] = extensions
        return self.add("materials", out)

    def image(self, data, kind="image/png"):
        return self.add("images", {"bufferView": self.view(data), "mimeType": kind})

    def texture(self, image, **sampler):
        return self.add("textures", {"source": image, "sampler": self.add("samplers", sampler)})

    def camera(self, eye, target, degrees=35.0, near=0.05):
        lens = {"type": "perspective", "perspective": {"yfov": single(math.radians(degrees)), "znear": near}}
        index = self.add("cameras", lens)
        self.node(name="camera", camera=index, translation=eye, rotation=looking(eye, target))

    def light(self, translation, rotation, **light):
        self.extension("KHR_lights_punctual")
        lights = self.root.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {}).setdefault("lights", [])
        lights.append(light)
        use = {"KHR_lights_punctual": {"light": len(lights) - 1}}
        self.node(name=light["name"], translation=translation, rotation=rotation, extensions=use)

    def _json(self, buffer):
        root = dict(self.root, buffers=[buffer, *self.more_buffers])
        return json.dumps(root, indent=1, sort_keys=True).encode()

    def write_gltf(self, file):
        uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(self.bin)).decode()
        file.write_bytes(self._json({"byteLength": len(self.bin), "uri": uri}) + b"\n")

    def write_glb(self, file):
        self.bin += b"\0" * (-len(self.bin) % 4)
        text = self._json({"byteLength": len(self.bin)})
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(self.bin), 0x004E4942) + self.bin
        file.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks)


# --- shapes: dictionaries that Gltf.primitive takes --------------------------------------------------------------


def quad(width=1.0, height=1.0, u=(0.0, 1.0), v=(0.0, 1.0)):
    """Upright, facing +Z; u and v from left to right and from top to bottom."""
    x, y = width / 2, height / 2
    return dict(
        positions=[[-x, -y, 0], [x, -y, 0], [x, y, 0], [-x, y, 0]],
        normals=[[0, 0, 1]] * 4,
        uv=[[u[0], v[1]], [u[1], v[1]], [u[1], v[0]], [u[0], v[0]]],
        indices=[0, 1, 2, 0, 2, 3],
    )


def ground(size):
    """A square on the floor, facing +Y."""
    h = size / 2
    return dict(
        positions=[[-h, 0, h], [h, 0, h], [h, 0, -h], [-h, 0, -h]],
        normals=[[0, 1, 0]] * 4,
        uv=[[0, 1], [1, 1], [1, 0], [0, 0]],
        indices=[0, 1, 2, 0, 2, 3],
    )


def box(x=1.0, y=1.0, z=1.0):
    """Around the origin, with 24 vertices, so that edges are sharp."""
    out = dict(positions=[], normals=[], uv=[], indices=[])
    half = [x / 2, y / 2, z / 2]
    for axis in range(3):
        for sign in (1, -1):
            n = [0, 0, 0]
            n[axis] = sign
            up = [0, 0, -sign] if axis == 1 else [0, 1, 0]
            right = cross(up, n)
            first = len(out["positions"])
            for a, b, u, v in ((-1, -1, 0, 1), (1, -1, 1, 1), (1, 1, 1, 0), (-1, 1, 0, 0)):
                out["positions"].append([half[i] * (n[i] + a * right[i] + b * up[i]) for i in range(3)])
                out["normals"].append(n)
                out["uv"].append([u, v])
            out["indices"] += [first + i for i in (0, 1, 2, 0, 2, 3)]
    return out


def sphere(radius=0.5, rings=10, segments=20, with_uv=False):
    out = dict(positions=[], normals=[], indices=[])
    uv = []
    for i in range(rings + 1):
        for j in range(segments + 1):
            polar, azimuth = math.pi * i / rings, 2 * math.pi * j / segments
            n = [math.sin(polar) * math.sin(azimuth), math.cos(polar), math.sin(polar) * math.cos(azimuth)]
            out["normals"].append(n)
            out["positions"].append([radius * c for c in n])
            uv.append([j / segments, i / rings])
    for i in range(rings):
        for j in range(segments):
            a = i * (segments + 1) + j
            b = a + segments + 1
            out["indices"] += [a, b, a + 1] * (i > 0) + [a + 1, b, b + 1] * (i + 1 < rings)
    return dict(out, uv=uv) if with_uv else out

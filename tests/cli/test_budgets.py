"""What a scene may claim is bounded, and each refusal says by what and how to raise it."""

import struct
import zlib

from harness import CliTest, INVALID, OK, USAGE, main, needs_device, triangle_gltf

NODES_2 = "has 3 nodes, more than load.nodes=2 allows; -D load.nodes=3 allows it"


def png(width, height):
    """A red picture."""
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    rows = zlib.compress((b"\0" + b"\xff\0\0" * width) * height)
    chunks = [(b"IHDR", header), (b"IDAT", rows), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks)


class Budgets(CliTest):
    def setUp(self):
        """Three nodes, one under another; a triangle that shows a picture of 8 x 4 pixels."""
        super().setUp()
        self.write("red.png", png(8, 4))
        self.scene = self.write("a.gltf", triangle_gltf(
            nodes=[{"children": [1]}, {"children": [2]}, {"mesh": 0}],
            meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
            materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            textures=[{"source": 0}],
            images=[{"uri": "red.png"}]))

    def test_each_refuses_one_less_than_is_needed(self):
        needed = {
            "bytes": (self.scene.stat().st_size, "a.gltf: is "),
            "nodes": (3, "/nodes: has "),
            "elements": (9, "with it, the scene has "),  # three positions, and as many normals and indices that are made
            "pixels": (32, "/images/0: is 8 x 4: "),
            "image_size": (8, "/images/0: is 8 x 4: "),
            "depth": (6, "nests to a depth of "),  # file, meshes, mesh, primitives, primitive, attributes
        }
        for key, (enough, place) in needed.items():
            with self.subTest(key=key):
                less = f"load.{key}={enough - 1}"
                self.expect(INVALID, "info", "a.gltf", "-D", less, says=f"more than {less} allows; -D load.{key}={enough} allows it")
                self.expect(INVALID, "info", "a.gltf", "-D", less, says=place)
                self.expect(OK, "info", "a.gltf", "-D", f"load.{key}={enough}")

    def test_flags_and_files_set_them(self):
        config = self.write("c.toml", "[load]\nnodes = 2\n")
        for verb in ("info", "render", "reference"):
            self.expect(INVALID, verb, "a.gltf", "--config", config, says=NODES_2)
            self.expect(INVALID, verb, "a.gltf", "-D", "load.nodes=2", says=NODES_2)
            self.expect(USAGE, verb, "a.gltf", "-D", "load.nodes=0", says="from 1 to 67108864 nodes")
        self.expect(OK, "info", "a.gltf", "--config", config, "-D", "load.nodes=3")

    @needs_device
    def test_bench_has_them(self):
        self.expect(INVALID, "bench", "a.gltf", "-D", "load.nodes=2", says=NODES_2)


if __name__ == "__main__":
    main()

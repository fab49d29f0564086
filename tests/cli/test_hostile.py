"""Hostile surroundings and hostile files: signals while loading, full disks, folders without permission, damaged scenes."""

import json
import os
import pathlib
import signal
import struct
import subprocess
import time

from harness import (BINARY, CliTest, INTERRUPTED, INVALID, MISSING, NOT_WRITTEN, OK, SMALL, TERMINATED, UNSUPPORTED, main,
                     needs_device, triangle_gltf)

SANITIZED = os.environ.get("VELARIUM_SANITIZE", "") != ""

# However it is damaged, no file keeps a user waiting longer.
PATIENCE_S = 5

# Errors of the validator after which there is nothing to read, whatever one makes of the rest.
FATAL = {"ACCESSOR_TOO_LONG", "BUFFER_VIEW_TOO_LONG", "BUFFER_BYTE_LENGTH_MISMATCH", "NODE_LOOP", "NODE_PARENT_OVERRIDE",
         "UNRESOLVED_REFERENCE", "ACCESSOR_INDEX_OOB", "CAMERA_ZFAR_LEQUAL_ZNEAR", "GLB_INVALID_MAGIC",
         "GLB_UNEXPECTED_END_OF_CHUNK_DATA", "UNKNOWN_ASSET_MAJOR_VERSION"}


class Fifo:
    """A scene file that never ends: whoever reads it waits, until a signal comes."""

    def __init__(self, path):
        os.mkfifo(path)
        self.path = path

    def __enter__(self):
        # Opened both ways, so that opening waits for nobody.
        self.descriptor = os.open(self.path, os.O_RDWR)
        os.write(self.descriptor, b'{"asset": ')
        return self

    def __exit__(self, *_):
        os.close(self.descriptor)


class SignalsWhileLoading(CliTest):
    def interrupt(self, number):
        with Fifo(self.folder / "endless.gltf"):
            process = self.start("render", "endless.gltf", *SMALL, "-o", "a.png")
            time.sleep(0.5)
            self.assertIsNone(process.poll(), "ended before the signal")
            process.send_signal(number)
            process.communicate(timeout=20)
        (self.folder / "endless.gltf").unlink()
        return process.returncode

    def test_signals_end_it_and_leave_nothing(self):
        for number, code in ((signal.SIGINT, INTERRUPTED), (signal.SIGTERM, TERMINATED)):
            self.assertEqual(self.interrupt(number), code)
            self.assertEqual(self.names(), [])


class Disks(CliTest):
    """Each test has a small file system of its own at disk/."""

    def mount(self, options):
        disk = self.folder / "disk"
        disk.mkdir()
        command = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(disk)]
        if os.geteuid() != 0 or subprocess.run(command, capture_output=True, check=False).returncode != 0:
            self.skipTest("only root may mount a disk, and not everywhere")
        self.addCleanup(subprocess.run, ["umount", str(disk)], check=True)
        return disk

    @needs_device
    def test_a_picture_that_does_not_fit_leaves_what_was_there(self):
        disk = self.mount("size=64k")
        # Half floats of 320 x 200 pixels are 512 kB; the spheres do not compress to an eighth of it.
        arguments = ["render", "--size", "320x200", "--spp", "1", "-o", "disk/a.exr"]
        self.expect(NOT_WRITTEN, *arguments, says="No space left")
        self.assertEqual(list(disk.iterdir()), [])
        before = b"the picture of yesterday"
        (disk / "a.exr").write_bytes(before)
        self.expect(NOT_WRITTEN, *arguments, says="No space left")
        self.assertEqual([path.read_bytes() for path in disk.iterdir()], [before])

    def test_a_disk_that_is_read_only(self):
        self.mount("ro")
        self.expect(NOT_WRITTEN, "render", *SMALL, "-o", "disk/a.png", says="ead-only")


def malformed_scenes():
    folder = pathlib.Path(os.environ.get("VELARIUM_ASSETS", "/nonexistent")) / "malformed"
    return sorted(path for path in folder.rglob("*") if path.suffix in (".gltf", ".glb"))


def fatal_places(scene):
    """The JSON pointers of what the validator's report says is unreadable, outside extensions."""
    report = pathlib.Path(f"{scene}.report.json")
    if not report.exists():
        return set()
    messages = json.loads(report.read_text(encoding="utf-8"))["issues"]["messages"]
    return {message.get("pointer", "") for message in messages if message["severity"] == 0 and message["code"] in FATAL
            and "/extensions/" not in message.get("pointer", "")}


class DamagedScenes(CliTest):
    def test_collected_ones_end_in_order_and_in_time(self):
        scenes = malformed_scenes()
        if not scenes:
            self.skipTest("VELARIUM_ASSETS names no folder with 'malformed' in it")
        fatal = named = 0
        for scene in scenes:
            with self.subTest(scene=scene.name):
                start = time.monotonic()
                code, out, err = self.run_velarium("info", scene)
                self.assertLess(time.monotonic() - start, PATIENCE_S)
                self.assertIn(code, (OK, MISSING, INVALID, UNSUPPORTED), out + err)
                places = fatal_places(scene)
                if places:
                    self.assertNotEqual(code, OK, f"read, although {places} is wrong")
                    fatal += 1
                    named += any(place in err for place in places)
        # Where a file has several faults, the reader may meet another one first.
        self.assertGreaterEqual(named, 0.9 * fatal, f"{named} of {fatal} refusals name the validator's place")

    def test_sizes_from_a_liar(self):
        """Counts near the ends of their types are refused before memory is asked for."""
        for count in (2**31 - 1, 2**32 - 1, 2**53, 2**63 - 1, 2**64 - 1):
            accessor = {"componentType": 5126, "count": count, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}
            self.write("a.gltf", triangle_gltf(accessors=[accessor]))
            self.expect(INVALID, "info", "a.gltf", says="/accessors/0/count")
        self.write("a.glb", struct.pack("<4sIIII", b"glTF", 2, 0xFFFFFFFF, 0xFFFFFFF0, 0x4E4F534A) + b"{}")
        self.expect(INVALID, "info", "a.glb", says="byte")

    def test_nesting_without_end(self):
        for text in ("[" * 10**6, '{"a":' * 10**6, '{"asset":' + "[" * 10**6 + "]" * 10**6 + "}"):
            self.write("a.gltf", text)
            self.expect(INVALID, "info", "a.gltf", says="a.gltf")

    def test_memory_that_is_not_there(self):
        """Under a limit of memory the program ends with a code, not with a signal."""
        if SANITIZED:
            self.skipTest("sanitizers need more address space than any limit leaves")
        self.write("a.gltf", triangle_gltf(buffers=[{"uri": "big.bin", "byteLength": 36}]))
        with open(self.folder / "big.bin", "wb") as big:
            big.truncate(3 << 30)   # takes no room on the disk
        limited = f"ulimit -v {2 << 20}; exec \"$0\" info a.gltf"   # kB
        process = subprocess.run(["bash", "-c", limited, BINARY], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 75, process.stdout + process.stderr)


if __name__ == "__main__":
    main()

"""The path tracer from outside. It needs no device."""

import json
import signal
import time

from harness import CliTest, INTERRUPTED, NOT_WRITTEN, OK, USAGE, main, read_png, triangle_gltf

SMALL = ["--size", "48x32", "--spp", "2"]
PARTS = (b"beauty", b"variance", b"albedo", b"normal", b"depth", b"direct", b"indirect")
POINTS = {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}]}


class Reference(CliTest):
    def trace(self, *arguments, output="out.png"):
        self.expect(OK, "reference", "builtin:cornell", *SMALL, "-o", output, *arguments)
        return (self.folder / output).read_bytes()

    def test_the_default_output_is_the_scenes_name(self):
        self.expect(OK, "reference", "builtin:cornell", *SMALL)
        self.assertEqual(self.names(), ["cornell.png"])

    def test_no_device_is_asked_for(self):
        self.expect(OK, "reference", "builtin:cornell", *SMALL, env={"VK_DRIVER_FILES": "/nonexistent",
                                                                     "VK_ICD_FILENAMES": "/nonexistent"})

    def test_pictures_have_the_size_that_was_asked(self):
        self.trace()
        width, height, channels, rows = read_png(self.folder / "out.png")
        self.assertEqual((width, height, channels, len(rows)), (48, 32, 3, 32))
        self.assertGreater(len({row[i:i + 3] for row in rows for i in range(0, len(row), 3)}), 50)

    def test_every_format_is_written(self):
        for name in ("a.png", "a.jpg", "a.webp", "a.exr", "a.hdr"):
            self.assertGreater(len(self.trace(output=name)), 100, name)

    def test_threads_change_no_byte_and_seeds_do(self):
        for name in ("a.png", "a.exr"):
            one = self.trace("--threads", "1", output=name)
            self.assertEqual(one, self.trace("--threads", "5", output=name))
            self.assertNotEqual(one, self.trace("--seed", "7", output=name))

    def test_exr_has_parts_and_says_how_it_was_made(self):
        exr = self.trace(output="out.exr")
        for part in PARTS:
            self.assertIn(part, exr)
        self.assertLess(exr.index(b"beauty"), exr.index(b"variance"))
        self.assertRegex(exr, rb"velarium:finished\0string\0\x03\0\0\0yes")
        for part in ("variance", "depth", "normal"):
            self.expect(OK, "compare", "out.exr", "out.exr", "--layer", part)

    def test_png_says_how_it_was_made(self):
        self.assertIn(b"tEXtvelarium:finished\0yes", self.trace())
        self.assertIn(b"tEXtvelarium:samples\x002", self.trace())

    def test_transport_takes_both_spellings(self):
        for flag, option in (("direct+env", "direct_env"), ("one-bounce", "one_bounce"), ("direct", "direct")):
            self.assertEqual(self.trace("--transport", flag), self.trace("-D", f"reference.transport={option}"))
        self.assertNotEqual(self.trace("--transport", "direct"), self.trace("--transport", "full"))
        self.assertNotEqual(self.trace("--shadows", "off"), self.trace("--shadows", "on"))
        self.assertNotEqual(self.trace("--emissive-lighting", "off"), self.trace("--emissive-lighting", "on"))
        pixels = []
        for flags in (("--max-bounces", "0"), ("--transport", "direct+env")):
            self.trace(*flags)
            pixels.append(read_png(self.folder / "out.png"))
        self.assertEqual(*pixels)

    def test_a_transparent_background_is_not_covered(self):
        self.write("a.gltf", triangle_gltf())
        self.expect(OK, "reference", "a.gltf", *SMALL, "--background", "transparent", "-o", "out.png")
        width, _, channels, rows = read_png(self.folder / "out.png")
        self.assertEqual(channels, 4)
        self.assertEqual(rows[0][3], 0)
        self.assertEqual(rows[16][4 * (width // 2) + 3], 255)

    def test_bad_input(self):
        self.expect(USAGE, "reference", "builtin:cornell", "--spp", "0", says="from 1 to")
        self.expect(USAGE, "reference", "builtin:cornell", "--transport", "magic", says="one_bounce")
        self.expect(USAGE, "reference", says="SCENE")
        self.expect(USAGE, "reference", "builtin:cornell", "-o", "out.tiff", says=".tiff")
        self.expect(NOT_WRITTEN, "reference", "builtin:cornell", "-o", "nowhere/out.png")
        self.assertEqual(self.names(), [])

    def test_what_cannot_be_traced_is_said(self):
        self.write("points.gltf", triangle_gltf(**POINTS))
        self.expect(OK, "reference", "points.gltf", *SMALL, says="points or lines are left out")
        self.expect(OK, "reference", "points.gltf", *SMALL, says="no triangles")
        self.expect(OK, "reference", "builtin:spheres", *SMALL, "--env-intensity", "0", says="black")

    def test_lamps_may_have_a_radius(self):
        def lit(extras):
            lamp = {"type": "point", "intensity": 30.0, "extras": extras}
            self.write("lamp.gltf", triangle_gltf(
                extensions={"KHR_lights_punctual": {"lights": [lamp]}}, extensionsUsed=["KHR_lights_punctual"],
                nodes=[{"mesh": 0}, {"translation": [0, 0, 1], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
                scenes=[{"nodes": [0, 1]}]))
            self.expect(OK, "reference", "lamp.gltf", *SMALL, "-o", "out.png")
            return read_png(self.folder / "out.png")
        point = lit({})
        self.assertNotEqual(lit({"radius": 0.9}), point)
        for other in ("wide", 3, {"radius": "wide"}, {"radius": -1}, {"radius": 0}, [0.9]):
            self.assertEqual(lit(other), point, other)

    def test_time_and_noise_end_a_picture(self):
        for flag, value in (("--time-limit", "0.5"), ("--noise", "0.9")):
            self.expect(OK, "reference", "builtin:cornell", "--size", "48x32", "--spp", "1000000", flag, value,
                        "--timings", "t.json")
            timings = json.loads((self.folder / "t.json").read_text())
            self.assertTrue(timings["finished"])
            self.assertLess(timings["samples"], 1000000)

    def test_an_interrupt_keeps_what_there_is(self):
        process = self.start("reference", "builtin:cornell", "--size", "48x32", "--spp", "1000000", "-o", "out.png",
                             "--progress", "json")
        process.stderr.readline()
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertIn("marked as unfinished", err)
        self.assertIn(b"tEXtvelarium:finished\0no", (self.folder / "out.png").read_bytes())

    def test_progress_is_one_object_a_line(self):
        *_, err = self.run_velarium("reference", "builtin:cornell", "--size", "160x90", "--spp", "16", "--progress", "json")
        lines = [json.loads(line) for line in err.splitlines() if line.startswith("{")]
        self.assertTrue(lines)
        self.assertEqual(lines[-1]["share"], 1.0)
        for line in lines:
            self.assertTrue(0.0 <= line["share"] <= 1.0)
            self.assertGreaterEqual(line["seconds_left"], 0.0)


if __name__ == "__main__":
    main()

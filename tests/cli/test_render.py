"""What the program does with a device: pictures, reports, progress, signals."""

import json
import signal
import struct
import time

from harness import (CliTest, INTERRUPTED, INVALID, MISSING, NO_DEVICE, OK, SMALL, TERMINATED, TRIANGLE, USAGE, data_uri, main,
                     needs_device, read_png, triangle_gltf)

LAMP = {"extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 3.0}]}},
        "extensionsUsed": ["KHR_lights_punctual"],
        "nodes": [{"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}]}

# Two cameras, before and behind the triangle, which faces +Z and is seen from there alone.
CAMERAS = {"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
           "nodes": [{"mesh": 0}, {"camera": 0, "name": "front", "translation": [0, 0, 4]},
                     {"camera": 0, "name": "back", "translation": [0, 0, -4], "rotation": [0, 1, 0, 0]}],
           "scenes": [{"nodes": [0, 1, 2]}]}


def moving_gltf():
    """The triangle moves 2 m to the right within a second; the camera stays."""
    times, places = struct.pack("<2f", 0, 1), struct.pack("<6f", 0, 0, 0, 2, 0, 0)
    data = TRIANGLE + times + places
    views = [{"buffer": 0, "byteOffset": offset, "byteLength": size} for offset, size in ((0, 36), (36, 8), (44, 24))]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                 {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                 {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}]
    move = {"name": "move", "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}
    return triangle_gltf(buffers=[{"uri": data_uri(data), "byteLength": len(data)}], bufferViews=views,
                         accessors=accessors, animations=[move], **CAMERAS)


def total(png):
    return sum(sum(row) for row in read_png(png)[3])


@needs_device
class Pictures(CliTest):
    def test_the_default_output_is_the_scenes_name(self):
        self.expect(OK, *SMALL)
        self.assertEqual(self.names(), ["atrium.png"])
        self.write("a.gltf", triangle_gltf())
        self.expect(OK, "a.gltf", *SMALL)
        self.assertEqual(self.names(), ["a.gltf", "a.png", "atrium.png"])

    def test_the_size_is_what_was_asked(self):
        width, height, channels, rows = read_png(self.render())
        self.assertEqual((width, height, channels, len(rows)), (48, 32, 3, 32))

    def test_a_picture_is_not_blank(self):
        *_, rows = read_png(self.render())
        self.assertGreater(len({row[i:i + 3] for row in rows for i in range(0, len(row), 3)}), 100)

    def test_two_runs_are_equal_bytes(self):
        for name in ("a.png", "a.exr", "a.jpg", "a.webp", "a.hdr"):
            self.assertEqual(self.render(output=name).read_bytes(), self.render(output="again-" + name).read_bytes(), name)

    def test_every_format_has_its_signature(self):
        signatures = {"a.png": b"\x89PNG", "a.jpg": b"\xff\xd8\xff", "a.jpeg": b"\xff\xd8\xff", "a.webp": b"RIFF",
                      "a.exr": b"\x76\x2f\x31\x01", "a.hdr": b"#?RADIANCE", "A.PNG": b"\x89PNG"}
        for name, start in signatures.items():
            self.assertTrue(self.render(output=name).read_bytes().startswith(start), name)

    def test_sixteen_bits(self):
        path = self.render("-D", "output.bits=16")
        self.assertEqual(path.read_bytes()[24], 16)

    def test_a_transparent_background_has_straight_alpha(self):
        # White before nothing: edge pixels are partly covered, and as white as the others.
        white = {"doubleSided": True, "extensions": {"KHR_materials_unlit": {}}}
        mesh = {"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}
        self.write("a.gltf", triangle_gltf(materials=[white], meshes=[mesh], extensionsUsed=["KHR_materials_unlit"]))
        path = self.render("a.gltf", "--background", "transparent", "--spp", "16", "--tonemap", "linear", "--env", "none",
                           "-D", "display.dither=off")
        _, _, channels, rows = read_png(path)
        self.assertEqual(channels, 4)
        pixels = [row[i:i + 4] for row in rows for i in range(0, len(row), 4)]
        alphas = {pixel[3] for pixel in pixels}
        self.assertTrue({0, 255} <= alphas and len(alphas) > 2, alphas)
        for pixel in pixels:
            if pixel[3] >= 16:
                self.assertGreaterEqual(min(pixel[:3]), 250, pixel)

    def test_a_coloured_background_is_that_colour(self):
        _, _, _, rows = read_png(self.render("--background", "#3366cc"))
        self.assertEqual(tuple(rows[0][:3]), (0x33, 0x66, 0xcc))

    def test_quiet_says_nothing(self):
        code, out, err = self.run_velarium("render", "builtin:spheres", *SMALL, "-q", "-o", "a.png")
        self.assertEqual((code, out, err), (OK, "", ""))

    def test_the_last_line_says_what_was_written(self):
        out = self.expect(OK, "render", "builtin:spheres", *SMALL, "-o", "a.png")
        self.assertRegex(out, r"^wrote a\.png: 48 x 32, [\d.]+ k?B, 1 frame of .* on .+\n$")


@needs_device
class Flags(CliTest):
    """Every flag changes what it says, or is accepted where nothing is to be seen."""

    def test_flags_that_change_the_picture(self):
        base = self.render().read_bytes()
        for flags in (["--exposure", "1"], ["--exposure", "auto"], ["--ev100", "2"], ["--tonemap", "agx"],
                      ["--tonemap", "aces"], ["--tonemap", "linear"], ["--env", "none"], ["--env-rotate", "90"],
                      ["--env-intensity", "2"], ["--sun", "30,40"], ["--spp", "2"], ["--eye", "1,2,9", "--fov", "60"],
                      ["--eye", "1,2,9", "--target", "0,1,0", "--up", "1,0,0"], ["--background", "#ff0000"],
                      ["-D", "lighting.model=ryse"], ["-D", "display.exposure=1"]):
            self.assertNotEqual(self.render(*flags).read_bytes(), base, flags)

    def test_flags_that_do_not(self):
        base = self.render().read_bytes()
        for flags in (["--env-rotate", "0"], ["--camera", ""], ["-D", "frame.sync=paranoid"], ["--time", "0"],
                      ["--device", "0"], ["--validation"], ["-D", "frame.spp=1"], ["--allow-outside-files"], ["--progress", "none"], ["-v"]):
            self.assertEqual(self.render(*flags).read_bytes(), base, flags)

    def test_cameras_animations_and_environments_that_are_not_there(self):
        self.expect(USAGE, "render", "builtin:spheres", *SMALL, "--camera", "nobody", says="nobody")
        self.expect(USAGE, "render", "builtin:spheres", *SMALL, "--animation", "nothing", says="nothing")
        self.expect(MISSING, "render", "builtin:spheres", *SMALL, "--env", "none.hdr", says="none.hdr")
        self.expect(NO_DEVICE, "render", "builtin:spheres", *SMALL, "--device", "abacus", says="abacus")
        self.assertEqual(self.names(), [])

    def test_the_scenes_error_is_heard_before_the_engines(self):
        for _ in range(3):
            self.expect(MISSING, "render", "none.gltf", *SMALL, "--device", "abacus", says="none.gltf")
            self.expect(MISSING, "render", "none.gltf", *SMALL, "--env", "none.hdr", says="none.gltf")

    def test_cameras_by_name_and_index(self):
        self.write("a.gltf", triangle_gltf(**CAMERAS))
        front = self.render("a.gltf").read_bytes()
        back = self.render("a.gltf", "--camera", "back").read_bytes()
        self.assertNotEqual(front, back)
        for choice, picture in (("front", front), ("0", front), ("1", back)):
            self.assertEqual(self.render("a.gltf", "--camera", choice).read_bytes(), picture, choice)

    def test_times_and_animations(self):
        self.write("a.gltf", moving_gltf())
        start = self.render("a.gltf").read_bytes()
        end = self.render("a.gltf", "--time", "1").read_bytes()
        self.assertNotEqual(start, end)
        for animation in ("move", "0", "all"):
            self.assertEqual(self.render("a.gltf", "--time", "2", "--animation", animation).read_bytes(), end, animation)

    def test_environments(self):
        pictures = {self.render("--env", name).read_bytes() for name in ("studio", "white", "none")}
        self.assertEqual(len(pictures), 3)
        # One pixel of radiance 1 everywhere is what "white" means.
        self.write("one.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + 2 * b"\x80\x80\x80\x81")
        self.assertEqual(self.render("--env", "one.hdr").read_bytes(), self.render("--env", "white").read_bytes())
        self.write("cut.hdr", b"#?RADIANCE\n")
        self.expect(INVALID, "render", "builtin:spheres", *SMALL, "--env", "cut.hdr", says="cut.hdr")

    def test_light_and_exposure(self):
        self.write("a.gltf", triangle_gltf(**LAMP))
        dim = self.render("a.gltf", "--exposure", "-2", "--tonemap", "linear")
        bright = self.render("a.gltf", "--exposure", "0", "--tonemap", "linear", output="bright.png")
        self.assertGreater(total(bright), 1.5 * total(dim))

    def test_a_configuration_file_and_flags_after_it(self):
        self.write("c.toml", "[render]\nsize = '48x32'\noutput = 'c.png'\n[frame]\nspp = 1\n[display]\nexposure = 1\n")
        self.expect(OK, "render", "builtin:spheres", "--config", "c.toml")
        self.assertEqual((self.folder / "c.png").read_bytes(), self.render("--exposure", "1").read_bytes())
        self.expect(OK, "render", "builtin:spheres", "--config", "c.toml", "--exposure", "0", "-o", "d.png")
        self.assertEqual((self.folder / "d.png").read_bytes(), self.render().read_bytes())


@needs_device
class Reports(CliTest):
    def check_timings(self, timings):
        self.assertEqual((timings["width"], timings["height"], timings["spp"], timings["frames"]), (48, 32, 3, 3))
        self.assertGreater(timings["frame_ms"], 0)
        self.assertGreater(len(timings["passes"]), 1)
        for one in timings["passes"]:
            self.assertTrue(one["name"] and one["ms"] >= 0, one)
        self.assertTrue(timings["device"])
        self.assertGreater(timings["phases"]["render_ms"], 0)

    def test_timings_in_a_file_and_on_standard_output(self):
        self.expect(OK, "render", "builtin:spheres", *SMALL, "--spp", "3", "--timings", "t.json")
        self.check_timings(json.loads((self.folder / "t.json").read_text()))
        self.check_timings(json.loads(self.expect(OK, "render", "builtin:spheres", *SMALL, "--spp", "3", "--timings", "-")))

    def test_timings_tell_what_shadow_maps_take(self):
        def maps(*options):
            self.expect(OK, "render", "builtin:boxes?light=sun", *SMALL, *options, "--timings", "t.json")
            return json.loads((self.folder / "t.json").read_text())["shadow_maps"]

        self.assertEqual(maps("-D", "sun_shadows.enabled=off"), [])
        small = maps("-D", "shadows.memory=8")
        self.assertIn("sun_shadows.cascades", [one["name"] for one in small])
        self.assertLessEqual(sum(one["bytes"] for one in small), 8 << 20)

    def test_dumps(self):
        self.expect(OK, "render", "builtin:spheres", *SMALL, "--dump", "gbuffer.depth=d.exr", "--dump", "gbuffer.normal=n.png", "-o", "a.png")
        self.assertEqual(self.names(), ["a.png", "d.exr", "n.png"])
        self.assertEqual(read_png(self.folder / "n.png")[:2], (48, 32))

    def test_dumps_that_are_not_there(self):
        self.expect(USAGE, "render", "builtin:spheres", *SMALL, "--dump", "gbuffer.detph=d.png", says="gbuffer.depth")
        self.assertEqual(self.names(), [])

    def test_progress(self):
        _, _, err = self.run_velarium("render", "builtin:spheres", *SMALL, "--spp", "3", "--progress", "json")
        lines = [json.loads(line) for line in err.splitlines() if line.startswith("{")]
        self.assertEqual([(line["frame"], line["of"]) for line in lines], [(1, 3), (2, 3), (3, 3)])
        _, _, err = self.run_velarium("render", "builtin:spheres", *SMALL, "--spp", "3", "--progress", "plain")
        self.assertIn("frame 3 of 3", err)
        _, _, err = self.run_velarium("render", "builtin:spheres", *SMALL, "--spp", "3", "--progress", "bar")
        self.assertIn("\x1b[K[##########....", err)
        _, _, err = self.run_velarium("render", "builtin:spheres", *SMALL, "--spp", "3", "--progress", "none")
        self.assertNotIn("frame", err)

    def test_devices(self):
        devices = json.loads(self.expect(OK, "devices", "--json"))
        for device in devices:
            self.assertEqual(device["usable"], device["why_not"] == "", device)
        text = self.expect(OK, "devices")
        self.assertIn(devices[0]["name"], text)
        self.assertIn(f"binds {devices[0]['limits']['samplers']} samplers", text)


@needs_device
class Signals(CliTest):
    def interrupt(self, number):
        process = self.start("render", "--size", "640x360", "--spp", "60000", "--progress", "json", "-o", "a.png")
        process.stderr.readline()
        process.send_signal(number)
        process.communicate(timeout=60)
        return process.returncode

    def test_signals_leave_nothing(self):
        self.assertEqual(self.interrupt(signal.SIGINT), INTERRUPTED)
        self.assertEqual(self.interrupt(signal.SIGTERM), TERMINATED)
        self.assertEqual(self.names(), [])

    def test_an_ignored_signal_stays_ignored(self):
        process = self.start(*SMALL, "--spp", "20", preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=600)
        self.assertEqual(process.returncode, OK)


if __name__ == "__main__":
    main()

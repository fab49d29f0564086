"""What the program says with no device: help, wrong arguments, wrong files, wrong destinations."""

import json
import os
import pathlib
import subprocess

from harness import (BINARY, CliTest, INVALID, MISSING, NO_DEVICE, NOT_WRITTEN, OK, TRIANGLE, UNSUPPORTED, USAGE, main,
                     triangle_gltf)

# The Vulkan loader reads drivers from here, and there are none.
NO_DRIVERS = {"VK_DRIVER_FILES": "/nonexistent.json", "VK_ICD_FILENAMES": "/nonexistent.json"}


class Help(CliTest):
    def test_no_argument_asks_for_help(self):
        out = self.expect(OK)
        for verb in ("render", "info", "devices", "bench", "options"):
            self.assertIn(verb, out)

    def test_every_verb_has_help(self):
        for verb in ("render", "info", "devices", "bench", "options"):
            self.assertIn(f"velarium {verb}", self.expect(OK, verb, "--help"))

    def test_version(self):
        self.assertRegex(self.expect(OK, "--version"), r"^velarium \d+\.\d+\.\d+\n$")

    def test_options_are_listed_as_markdown(self):
        out = self.expect(OK, "options")
        self.assertIn("| `display.tonemap` | neutral, agx, aces, linear | neutral |", out)
        self.assertIn("| `frame.spp` | from 1 to 65536 frames | 4 |", out)

    def test_the_page_of_options_is_of_today(self):
        page = pathlib.Path(__file__).parents[2] / "docs" / "options.md"
        self.assertEqual(self.expect(OK, "options"), page.read_text(), "run: velarium options > docs/options.md")

    def test_a_full_standard_output_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        with open("/dev/full", "w", encoding="ascii") as full:
            process = subprocess.run([BINARY, "options"], stdout=full, stderr=subprocess.DEVNULL, check=False)
        self.assertEqual(process.returncode, NOT_WRITTEN)


class WrongArguments(CliTest):
    def test_unknown_flags_and_verbs_name_the_nearest(self):
        self.expect(USAGE, "render", "--exposre", "1", says="did you mean --exposure?")
        self.expect(USAGE, "render", "--sizes=1x1", says="did you mean --size?")
        self.expect(USAGE, "--outptu", "a.png", says="did you mean --output?")
        self.expect(USAGE, "info", "--jsno", "a.gltf", says="did you mean --json?")
        self.expect(USAGE, "rendr", says="did you mean render?")
        self.expect(USAGE, "render", "--zzzzzzzz", says="'--zzzzzzzz' is not a flag")

    def test_unknown_options_name_the_nearest(self):
        self.expect(USAGE, "render", "-D", "lighting.modle=ryse", says="did you mean lighting.model?")
        self.expect(USAGE, "render", "-D", "tonemap=agx", says="did you mean display.tonemap?")

    def test_values_out_of_range_name_the_range(self):
        self.expect(USAGE, "render", "--spp", "0", says="from 1 to 65536")
        self.expect(USAGE, "render", "--exposure", "33", says="from -32 to 32")
        self.expect(USAGE, "render", "--ev100", "nan", says="from -16 to 24")
        self.expect(USAGE, "render", "--tonemap", "filmic", says="neutral, agx, aces, linear")
        self.expect(USAGE, "render", "--env-rotate", "361", says="from -360 to 360")
        self.expect(USAGE, "render", "--env-intensity", "-1", says="from 0 to")
        self.expect(USAGE, "render", "--sun", "0,91", says="from -90 to 90")
        for sun in ("45", "45,", "45,30,", "45,30,4,1", "east,30"):
            self.expect(USAGE, "render", "--sun", sun, says="AZIMUTH,ELEVATION")
        self.expect(USAGE, "render", "-D", "lighting.occlusion=perhaps", says="on, off")
        self.expect(USAGE, "bench", "--frames", "1", says="from 2")
        self.expect(USAGE, "bench", "--warm-up", "x", says="from 0")

    def test_malformed_values(self):
        for size in ("0x5", "5x0", "5", "5x", "x5", "65536x1", "1x65536", "-1x1", "1.5x1", "1x1x1", "1 x 1"):
            self.expect(USAGE, "render", "--size", size, says="each from 1 to 65535")
        for point in ("1,2", "1,2,3,4", "1,2,x", "", "1,,3", "1,2,inf"):
            self.expect(USAGE, "render", "--eye", point, says="three numbers")
        for color in ("red", "#12345", "#1234567", "#gggggg", "#-12345"):
            self.expect(USAGE, "render", "--background", color, says="#rrggbb")
        for angle in ("0", "180", "-10", "wide"):
            self.expect(USAGE, "render", "--eye", "0,0,1", "--fov", angle, says="--fov")
        self.expect(USAGE, "render", "-D", "frame.spp", says="KEY=VALUE")
        self.expect(USAGE, "render", "--dump", "depth.png", says="KEY=VALUE")
        self.expect(USAGE, "render", "--time", "soon", says="not a number")
        self.expect(USAGE, "render", "--progress", "loud", says="auto, bar, plain, json, none")

    def test_missing_and_superfluous_arguments(self):
        self.expect(USAGE, "render", "--size", says="--size")
        self.expect(USAGE, "render", "a.gltf", "b.gltf", says="one argument too many")
        self.expect(USAGE, "info", says="SCENE")
        self.expect(USAGE, "devices", "extra", says="one argument too many")

    def test_contradictions(self):
        self.expect(USAGE, "render", "--target", "0,0,0", says="--target needs --eye")
        self.expect(USAGE, "render", "--up", "0,1,0", says="--up needs --eye")
        self.expect(USAGE, "render", "--fov", "30", says="--fov needs --eye")
        self.expect(USAGE, "render", "--eye", "0,0,1", "--camera", "auto", says="exclude each other")
        self.expect(USAGE, "render", "-q", "-v")


class Configuration(CliTest):
    def expect_refused(self, code, text, says):
        config = self.write("c.toml", text)
        self.expect(code, "render", "--config", config, says=says)

    def test_faults_name_line_and_column(self):
        self.expect_refused(INVALID, "[display]\nexposure = \n", says="c.toml: line 2, column 12")
        self.expect_refused(INVALID, "exposure = 1\n", says="line 1, column 12: 'exposure' stands outside a table")
        self.expect_refused(USAGE, "[display]\nexposure = 99\n", says="line 2, column 12: display.exposure")
        self.expect_refused(USAGE, "[display]\n\nexposrue = 1\n", says="line 3, column 12")
        self.expect_refused(USAGE, "[render]\nszie = '1x1'\n", says="did you mean size?")
        self.expect_refused(USAGE, "[render]\nsize = 12\n", says="line 2, column 8: --size")
        self.expect_refused(USAGE, "[render]\nvalidation = 'x'\n", says="true or false")
        self.expect_refused(USAGE, "[nothing]\nx = 1\n", says="'nothing.x' is not an option")

    def test_missing_files(self):
        self.expect(MISSING, "render", "--config", "none.toml", says="none.toml")
        self.expect(MISSING, "render", "--config", self.folder, says="is a directory")


class WrongFiles(CliTest):
    def test_inputs_that_are_not_there(self):
        for verb in ("render", "info"):
            self.expect(MISSING, verb, "none.gltf", says="none.gltf")
            self.expect(MISSING, verb, self.folder, says=str(self.folder))
            self.expect(MISSING, verb, "builtin:none", says="none")

    def test_inputs_that_are_no_scene(self):
        self.write("empty.gltf", "")
        self.write("rubbish.gltf", "rubbish")
        self.write("empty.glb", b"")
        self.write("cut.glb", b"glTF\2\0\0\0\xff\xff\0\0")
        for name in ("empty.gltf", "rubbish.gltf", "empty.glb", "cut.glb"):
            self.expect(INVALID, "info", name, says=name)
            self.expect(INVALID, "render", name, says=name)
        self.assertFalse([name for name in self.names() if name.endswith(".png")])

    def test_required_extensions_that_are_unknown(self):
        scene = triangle_gltf(extensionsUsed=["EXT_unheard_of"], extensionsRequired=["EXT_unheard_of"])
        self.write("a.gltf", scene)
        self.expect(UNSUPPORTED, "info", "a.gltf", says="EXT_unheard_of")

    def test_files_outside_the_scenes_folder(self):
        outside = [{"uri": "../triangle.bin", "byteLength": len(TRIANGLE)}]
        self.write("triangle.bin", TRIANGLE)
        (self.folder / "inside").mkdir()
        self.write("inside/a.gltf", triangle_gltf(buffers=outside))
        for verb in ("info", "render"):
            self.expect(INVALID, verb, "inside/a.gltf", says="triangle.bin")
        self.expect(OK, "info", "--allow-outside-files", "inside/a.gltf")

    def test_breaches_are_read_with_a_warning_or_refused(self):
        scene = triangle_gltf(materials=[{"pbrMetallicRoughness": {"metallicFactor": 7}}])
        self.write("a.gltf", scene)
        for verb in ("info", "render"):
            self.expect(OK, verb, "a.gltf", says="is 7, outside its range; 1 is used instead")
            self.expect(INVALID, verb, "--strict", "a.gltf", says="metallicFactor: is 7")

    def test_sizes_are_checked_before_the_scene(self):
        says = "at most 16383 pixels a side"
        self.expect(NOT_WRITTEN, "render", "none.gltf", "-o", "a.webp", "--size", "16384x4", says=says)

    def test_files_of_other_kinds_are_named(self):
        self.write("a.gltf", "version https://git-lfs.github.com/spec/v1\n")
        self.expect(INVALID, "info", "a.gltf", says="git lfs pull")

    def test_destinations_are_checked_before_the_scene(self):
        self.expect(NOT_WRITTEN, "render", "none.gltf", "-o", "nowhere/a.png", says="no folder")
        self.expect(NOT_WRITTEN, "render", "none.gltf", "--timings", "nowhere/t.json", says="no folder")
        self.expect(NOT_WRITTEN, "render", "none.gltf", "--dump", "gbuffer.depth=nowhere/d.exr", says="no folder")
        self.write("folder.png", "").unlink()
        (self.folder / "folder.png").mkdir()
        self.expect(NOT_WRITTEN, "render", "none.gltf", "-o", "folder.png", says="directory")
        self.expect(USAGE, "render", "none.gltf", "-o", "a.bmp", says=".png .jpg .jpeg .webp .exr .hdr")
        self.expect(USAGE, "render", "none.gltf", "-o", "picture", says="no ending")

    def test_destinations_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        self.expect(NOT_WRITTEN, "render", "none.gltf", "-o", "a.png", says="ermission")


class NoDevice(CliTest):
    def test_rendering_without_drivers(self):
        self.expect(NO_DEVICE, "render", env=NO_DRIVERS)
        self.expect(NO_DEVICE, "bench", env=NO_DRIVERS)
        self.assertEqual(self.names(), [])

    def test_a_machine_without_a_loader(self):
        # Found first, and no library: as good as none installed.
        for name in ("libvulkan.so.1", "libvulkan.so"):
            self.write(name, "not a library")
        without = {"LD_LIBRARY_PATH": str(self.folder)}
        self.expect(NO_DEVICE, "render", env=without, says="install libvulkan1")
        self.expect(NO_DEVICE, "devices", env=without, says="install libvulkan1")

    def test_info_needs_no_device(self):
        self.write("a.gltf", triangle_gltf())
        self.expect(OK, "info", "a.gltf", env=NO_DRIVERS)


class Info(CliTest):
    def test_counts_as_text_and_json(self):
        self.write("a.gltf", triangle_gltf())
        self.assertRegex(self.expect(OK, "info", "a.gltf"), r"triangles +1\n")
        info = json.loads(self.expect(OK, "info", "--json", "a.gltf"))
        self.assertEqual((info["nodes"], info["vertices"], info["triangles"]), (1, 3, 1))
        self.assertEqual(info["bounds"], {"min": [-1, -1, 0], "max": [1, 1, 0]})
        self.assertEqual(info["lights"], [])


if __name__ == "__main__":
    main()

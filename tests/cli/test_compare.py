"""Comparing pictures: exit codes, what is said and written, and the page as a browser shows it."""

import json
import shutil
import struct
import subprocess
import unittest
import zlib

from harness import CliTest, INVALID, MISSING, NOT_WRITTEN, OK, USAGE, main, read_png

DIFFERS = 1
CHROMIUM = shutil.which("chromium")


def png(width, height, color_at):
    """An 8-bit PNG; color_at(x, y) gives three or four values from 0 to 255."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(value for x in range(width) for value in color_at(x, y)) for y in range(height))
    color_type = 6 if len(color_at(0, 0)) == 4 else 2
    header = struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def exr(width, height, channels):
    """An uncompressed OpenEXR file (OpenEXR File Layout); channels maps names to the values of each pixel."""
    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data
    names = sorted(channels)
    listing = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = b"".join((
        attribute("channels", "chlist", listing), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)), b"\0"))
    start = 8 + len(header) + 8 * height
    lines = [b"".join(struct.pack(f"<{width}f", *channels[name][y * width:(y + 1) * width]) for name in names)
             for y in range(height)]
    table = b"".join(struct.pack("<Q", start + y * (8 + len(lines[0]))) for y in range(height))
    data = b"".join(struct.pack("<ii", y, len(line)) + line for y, line in enumerate(lines))
    return b"\x76\x2f\x31\x01" + struct.pack("<i", 2) + header + table + data


def grey_exr(values, width=4):
    return exr(width, len(values) // width, {name: values for name in "RGB"})


def ramp(x, y):
    return (8 * x, 12 * y, 100)


def spotted(x, y):
    return (255, 255, 255) if (x, y) == (5, 3) else ramp(x, y)


class CompareTest(CliTest):
    def setUp(self):
        super().setUp()
        self.write("ramp.png", png(24, 16, ramp))
        self.write("spotted.png", png(24, 16, spotted))

    def numbers(self, code, *arguments):
        return json.loads(self.expect(code, "compare", *arguments, "--json", "-"))


class Verdicts(CompareTest):
    def test_equal_pictures(self):
        out = self.expect(OK, "compare", "ramp.png", "ramp.png")
        self.assertIn("inf dB", out)
        for metric in ("flip", "psnr", "rmse", "relmse", "ssim", "share"):
            self.expect(OK, "compare", "ramp.png", "ramp.png", "--metric", metric)

    def test_any_difference_is_one_unless_a_threshold_allows_it(self):
        for metric, strict, lax in (("flip", 0, 0.5), ("psnr", 60, 10), ("rmse", 0, 0.5), ("relmse", 0, 5),
                                    ("ssim", 1, 0.5), ("share", 0.001, 0.5)):
            self.expect(DIFFERS, "compare", "spotted.png", "ramp.png", "--metric", metric, says="beyond the threshold")
            for threshold, code in ((strict, DIFFERS), (lax, OK)):
                self.expect(code, "compare", "spotted.png", "ramp.png", "--metric", metric, "--threshold", threshold)

    def test_a_share_that_equals_the_threshold_is_within(self):
        self.write("a.png", png(10, 10, lambda x, y: (255, 0, 0) if x == y == 4 else (x, y, 0)))
        self.write("b.png", png(10, 10, lambda x, y: (x, y, 0)))
        self.expect(OK, "compare", "a.png", "b.png", "--metric", "share", "--threshold", "0.01")
        self.expect(DIFFERS, "compare", "a.png", "b.png", "--metric", "share", "--threshold", "0.0099")

    def test_crop_mask_and_tolerance(self):
        self.expect(OK, "compare", "spotted.png", "ramp.png", "--crop", "6,0,18,16")
        self.expect(DIFFERS, "compare", "spotted.png", "ramp.png", "--crop", "4,2,8,8")
        self.write("mask.png", png(24, 16, lambda x, y: (0, 0, 0) if (x, y) == (5, 3) else (255, 255, 255)))
        self.expect(OK, "compare", "spotted.png", "ramp.png", "--mask", "mask.png", "--metric", "rmse")
        self.expect(OK, "compare", "spotted.png", "ramp.png", "--metric", "share", "--tolerance", "1")

    def test_quiet_says_the_difference_alone(self):
        code, out, err = self.run_velarium("compare", "spotted.png", "ramp.png", "-q")
        self.assertEqual((code, out, err.count("\n")), (DIFFERS, "", 1))
        self.assertEqual(self.run_velarium("compare", "ramp.png", "ramp.png", "-q"), (OK, "", ""))

    def test_alpha_counts(self):
        for name, alpha in (("clear.png", 0), ("opaque.png", 255)):
            self.write(name, png(4, 4, lambda x, y, alpha=alpha: (0, 0, 0, alpha)))
        self.expect(DIFFERS, "compare", "clear.png", "opaque.png", "--threshold", "0.9")


class Help(CliTest):
    def test_completion_offers_the_flags_of_the_help(self):
        told = self.expect(OK, "compare", "--help")
        offered = self.expect(OK, "completion", "words", "--", "compare", "--").splitlines()
        self.assertGreater(len(offered), 10)
        for line in offered:
            self.assertIn(line.split("\t")[0], told)
        self.assertIn("ssim", self.expect(OK, "completion", "words", "--", "compare", "--metric", "s"))

    def test_the_manual_names_both_operands(self):
        self.assertIn("PICTURE REFERENCE", self.expect(OK, "options", "--man"))


class LinearLight(CompareTest):
    def setUp(self):
        super().setUp()
        self.write("a.exr", grey_exr([0.5] * 8 + [4.0] * 8))
        self.write("b.exr", grey_exr([0.6] * 8 + [4.0] * 8))

    def test_numbers_are_of_light(self):
        found = self.numbers(DIFFERS, "a.exr", "b.exr")
        self.assertEqual(found["values"], "linear")
        self.assertAlmostEqual(found["metrics"]["rmse"], (0.01 / 2) ** 0.5, 6)
        self.assertGreater(found["exposures"]["count"], 1)
        self.assertEqual(self.numbers(OK, "a.exr", "a.exr")["metrics"]["psnr"], None)

    def test_not_a_number_and_infinity_name_file_and_pixel(self):
        for bad in (float("nan"), float("inf")):
            self.write("bad.exr", grey_exr([0.5] * 6 + [bad] + [0.5] * 9))
            self.expect(INVALID, "compare", "a.exr", "bad.exr", says="bad.exr: pixel (2, 1)")
            self.expect(INVALID, "compare", "bad.exr", "a.exr", says="bad.exr: pixel (2, 1)")

    def test_layers(self):
        values = {f"{layer}.{channel}": [value] * 16 for layer, value in (("sun", 1.0), ("sky", 2.0)) for channel in "RGB"}
        self.write("layers.exr", exr(4, 4, values))
        self.expect(INVALID, "compare", "layers.exr", "layers.exr", says="channels R, G and B")
        self.expect(OK, "compare", "layers.exr", "layers.exr", "--layer", "sun")
        self.expect(USAGE, "compare", "layers.exr", "layers.exr", "--layer", "moon", says="there are sky, sun")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--layer", "sun", says="only OpenEXR files have layers")

    def test_with_display_values_light_is_clamped_and_encoded(self):
        self.write("half.png", png(4, 4, lambda x, y: (188, 188, 188) if y < 2 else (255, 255, 255)))
        self.expect(OK, "compare", "a.exr", "half.png", "--metric", "share", says="a.exr holds linear light")
        self.expect(OK, "compare", "a.exr", "b.exr", "--display", "--exposure", "1", "--metric", "rmse")


class Refusals(CompareTest):
    def test_wrong_arguments(self):
        self.expect(USAGE, "compare", "ramp.png", says="REFERENCE is required; velarium compare --help tells what")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "ramp.png", says="one argument too many")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--metric", "flop", says="did you mean flip?")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--threshold", "low", says="--threshold: 'low'")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--threshold", "nan", says="--threshold")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--htlm", "a.html", says="did you mean --html?")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--pixels-per-degree", "0", says="from 1 to 1000")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--exposure", "33", says="from -32 to 32")
        self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--tolerance", "-1", says="0 or more")
        for crop in ("1,2,3", "1,2,3,4,5", "-1,0,1,1", "0,0,0,1", "a,b,c,d", "1,1,24,1", ""):
            self.expect(USAGE, "compare", "ramp.png", "ramp.png", "--crop", crop)

    def test_wrong_files(self):
        self.expect(MISSING, "compare", "none.png", "ramp.png", says="none.png")
        self.expect(MISSING, "compare", "ramp.png", "ramp.png", "--mask", "none.png", says="none.png")
        self.write("text.png", "no picture")
        self.expect(INVALID, "compare", "ramp.png", "text.png", says="text.png: is not a PNG")
        self.write("small.png", png(4, 4, ramp))
        self.expect(INVALID, "compare", "small.png", "ramp.png", says="small.png: has 4 x 4 pixels, ramp.png has 24 x 16")
        self.expect(INVALID, "compare", "ramp.png", "ramp.png", "--mask", "small.png", says="the mask has 4 x 4")

    def test_blank_pictures_are_said(self):
        self.write("blank.png", png(4, 4, lambda x, y: (9, 9, 9)))
        self.expect(OK, "compare", "blank.png", "blank.png", says="note: blank.png: every pixel has the same colour")

    def test_destinations_are_checked_before_pictures(self):
        for flag in ("--error-map", "--html", "--json"):
            self.expect(NOT_WRITTEN, "compare", "none.png", "none.png", flag, "nowhere/a.png", says="no folder")
        self.expect(USAGE, "compare", "none.png", "none.png", "--error-map", "a.bmp", says=".png")


class Outputs(CompareTest):
    def test_the_error_map_is_dark_where_pictures_are_equal(self):
        self.expect(DIFFERS, "compare", "spotted.png", "ramp.png", "--error-map", "error.png")
        width, height, channels, rows = read_png(self.folder / "error.png")
        self.assertEqual((width, height, channels), (24, 16, 3))
        lights = [[sum(row[3 * x:3 * x + 3]) for x in range(width)] for row in rows]
        self.assertEqual(lights[15][23], 0)
        self.assertEqual(max(max(row) for row in lights), lights[3][5])

    def test_the_error_map_as_numbers(self):
        found = self.numbers(DIFFERS, "spotted.png", "ramp.png", "--error-map", "error.exr")
        self.write("black.exr", grey_exr([0.0] * 24 * 16, 24))
        map_itself = self.numbers(DIFFERS, "error.exr", "black.exr")
        self.assertLess(map_itself["metrics"]["rmse"], found["metrics"]["flip"] ** 0.5)
        self.assertEqual((map_itself["largest"]["x"], map_itself["largest"]["y"]), (5, 3))

    def test_numbers_as_json(self):
        found = self.numbers(DIFFERS, "spotted.png", "ramp.png", "--threshold", "0.001")
        self.assertEqual((found["metric"], found["threshold"], found["within"]), ("flip", 0.001, False))
        self.assertEqual((found["width"], found["height"], found["pixels"]), (24, 16, 384))
        self.assertEqual((found["largest"]["x"], found["largest"]["y"]), (5, 3))
        self.assertAlmostEqual(found["metrics"]["share"], 1 / 384)
        out = self.expect(DIFFERS, "compare", "spotted.png", "ramp.png", "--json", "numbers.json")
        self.assertIn("FLIP", out)
        self.assertEqual(json.loads((self.folder / "numbers.json").read_text())["picture"], "spotted.png")


@unittest.skipUnless(CHROMIUM, "no chromium to show the page")
class Page(CompareTest):
    """The picture is red and the reference blue, so that one sees which of them is where."""

    def setUp(self):
        super().setUp()
        self.write("red.png", png(40, 30, lambda x, y: (255, 0, 0)))
        self.write("blue.png", png(40, 30, lambda x, y: (0, 0, 255)))
        self.expect(DIFFERS, "compare", "red.png", "blue.png", "--html", "page.html")
        self.page = (self.folder / "page.html").read_text()

    def browse(self, *arguments, view="slide", page="page.html"):
        profile = self.folder / "profile"
        command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                   f"--user-data-dir={profile}", "--host-resolver-rules=MAP * 0.0.0.0", *arguments,
                   f"file://{self.folder}/{page}#view={view}"]
        return subprocess.run(command, capture_output=True, text=True, check=True, timeout=300).stdout

    def columns(self, view):
        """How many columns of a screenshot show the picture and the reference, and where the first of each is."""
        shot = self.folder / f"{view}.png"
        self.browse("--window-size=1000,1100", f"--screenshot={shot}", view=view)
        _, _, channels, rows = read_png(shot)
        row = rows[500]
        pixels = [tuple(row[i:i + 3]) for i in range(0, len(row), channels)]
        reds = [x for x, pixel in enumerate(pixels) if pixel == (255, 0, 0)]
        blues = [x for x, pixel in enumerate(pixels) if pixel == (0, 0, 255)]
        return reds, blues

    def test_the_divider_has_the_picture_left_and_the_reference_right(self):
        reds, blues = self.columns("slide")
        self.assertGreater(len(reds), 300)
        self.assertAlmostEqual(len(reds), len(blues), delta=4)
        self.assertLess(max(reds), min(blues))

    def test_each_picture_can_be_seen_alone(self):
        reds, blues = self.columns("picture")
        self.assertTrue(len(reds) > 600 and not blues)
        reds, blues = self.columns("reference")
        self.assertTrue(len(blues) > 600 and not reds)
        self.assertEqual(self.columns("error"), ([], []))

    def test_keys_work(self):
        keys = ("ArrowLeft", "ArrowLeft", "+", "+", "4")
        press = f"for (const key of {list(keys)}) document.body.dispatchEvent(new KeyboardEvent('keydown', {{key, bubbles: true}}));"
        self.write("pressed.html", self.page.replace("</body>", f"<script>{press}</script></body>"))
        document = self.browse("--dump-dom", page="pressed.html")
        self.assertIn('data-view="error"', document)
        self.assertIn("--split: 48%", document)
        self.assertIn("width: 80px", document)

    def test_the_page_needs_nothing_else(self):
        self.assertNotIn("://", self.page)
        self.assertNotRegex(self.page, r"(src|href)=\"(?!data:image/png;base64,)")


if __name__ == "__main__":
    main()

"""Runs the programs of examples/ as they are, and looks at what they leave. usage: test_examples.py CLASS"""

import os
import re
import subprocess
import sys

from harness import OK, CliTest, needs_device, read_png

FOLDER = os.environ["VELARIUM_EXAMPLES"]


class ExampleTest(CliTest):
    def run_example(self, name):
        """Runs in the empty folder of the test; returns what was printed."""
        done = subprocess.run([os.path.join(FOLDER, "example_" + name)], cwd=self.folder, capture_output=True, text=True,
                              check=False, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def expect_same(self, picture, *render):
        """The picture is to a pixel what the program renders with these arguments."""
        self.expect(OK, "render", *render, "-o", "expected.png")
        self.expect(OK, "compare", picture, "expected.png", "--metric", "share", "--threshold", "0")

    def pixels(self, name):
        """Function of x and y, from 0 to 1 from the top left, to the mean colour of 5 x 5 pixels, 0 to 255."""
        width, height, channels, rows = read_png(self.folder / name)

        def at(x, y):
            left, top = int(x * width) - 2, int(y * height) - 2
            area = [rows[top + i][(left + j) * channels:][:3] for i in range(5) for j in range(5)]
            return [sum(pixel[c] for pixel in area) / len(area) for c in range(3)]

        return (width, height), at


@needs_device
class Hello(ExampleTest):
    def test_draws_what_the_program_draws(self):
        self.run_example("hello")
        self.assertEqual(self.names(), ["out.png"])
        self.assertEqual(read_png(self.folder / "out.png")[:2], (640, 360))
        self.expect_same("out.png", "builtin:spheres", "--size", "640x360")

    def test_is_five_lines(self):
        with open(os.path.join(os.environ["VELARIUM_SOURCE"], "examples", "hello.cpp"), encoding="utf-8") as file:
            body = file.read().split("int main() {\n")[1].rsplit("}", 1)[0]
        self.assertLessEqual(len(body.strip().split("\n")), 5)


@needs_device
class CameraPath(ExampleTest):
    def test_goes_around(self):
        self.run_example("camera_path")
        names = [f"orbit_{step:02}.png" for step in range(8)]
        self.assertEqual(self.names(), names)
        pictures = [(self.folder / name).read_bytes() for name in names]
        self.assertEqual(len(set(pictures)), 8)
        view = ["builtin:spheres", "--size", "320x180", "--spp", "4", "--target", "0,0.5,0"]
        self.expect_same("orbit_00.png", *view, "--eye", "0,3.5,8")
        # A quarter around: the cosine is what floats make of it, so that single pixels may round to another value.
        self.expect(OK, "render", *view, "--eye", "8,3.5,0", "-o", "quarter.png")
        self.expect(OK, "compare", "orbit_02.png", "quarter.png", "--metric", "share", "--threshold", "0.01")


@needs_device
class MadeInCode(ExampleTest):
    def test_shows_what_was_made(self):
        self.run_example("made_in_code")
        self.assertEqual(self.names(), ["made.png"])
        size, at = self.pixels("made.png")
        self.assertEqual(size, (320, 180))
        red, green, blue = at(0.67, 0.45)  # the gem
        self.assertGreater(red, 1.5 * max(green, blue), "the gem is red")
        red, green, blue = at(0.30, 0.45)  # the ball
        self.assertTrue(red > green > 1.3 * blue, f"the ball is golden: {red, green, blue}")
        light, dark = sum(at(0.40, 0.86)), sum(at(0.55, 0.86))  # two tiles of the floor
        self.assertGreater(max(light, dark), 2 * min(light, dark), "the floor is chequered")


@needs_device
class CompareWithReference(ExampleTest):
    def test_says_how_far(self):
        told = self.run_example("compare_with_reference")
        self.assertEqual(self.names(), ["difference.png", "rendered.png", "traced.png"])
        rendered, traced = map(float, re.search(r"rendered (\S+) m, traced (\S+) m", told).groups())
        self.assertAlmostEqual(rendered, traced, delta=0.02)
        self.assertTrue(6 < traced < 9, "the camera of the scene stands 8.6 m from its middle")
        flip, relmse = map(float, re.search(r"FLIP (\S+), relative error (\S+)", told).groups())
        self.assertTrue(0.01 < flip < 0.15, told)    # the noise of 16 paths, and light that went further than once
        self.assertTrue(0.0001 < relmse < 0.1, told)
        for name in self.names():
            self.assertEqual(read_png(self.folder / name)[:2], (160, 90))


if __name__ == "__main__":
    import unittest
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])

"""The benchmark from outside: figures, comparisons, sweeps, suites."""

import csv
import json

from harness import CliTest, INVALID, MISSING, NOT_WRITTEN, OK, USAGE, main, needs_device

DIFFERS = 1
TINY = ["--size", "48x32", "--frames", "3", "--warm-up", "1"]


def intervals(scene):
    return {one["name"]: one for one in scene["intervals"]}


@needs_device
class Figures(CliTest):
    def test_every_pass_has_a_median_and_its_noise(self):
        self.assertIn("frame on the device", self.expect(OK, "bench", "builtin:spheres", *TINY))
        bench = json.loads(self.expect(OK, "bench", "builtin:spheres", *TINY, "--rounds", "2", "--json", "-"))
        self.assertEqual((bench["frames"], bench["warm_up"], bench["rounds"]), (3, 1, 2))
        scene, = bench["scenes"]
        self.assertEqual((scene["scene"], scene["width"], scene["height"]), ("builtin:spheres", 48, 32))
        self.assertEqual(scene["frames"], 4)   # two rounds of three, the first of each not counted
        found = intervals(scene)
        self.assertLessEqual({"gbuffer", "lighting", "frame on the device", "frame by the clock"}, set(found))
        self.assertGreater(found["frame by the clock"]["ms"], 0)
        self.assertGreaterEqual(found["gbuffer"]["mad_ms"], 0)
        self.assertGreater(bench["process_peak_bytes"], 1 << 20)

    def test_a_comparison_marks_what_became_slower(self):
        self.expect(OK, "bench", "builtin:spheres", *TINY, "--json", "old.json")
        old = json.loads((self.folder / "old.json").read_text())
        for one in old["scenes"][0]["intervals"]:
            one.update(ms=one["ms"] * 1e-3, mad_ms=0)
        self.write("fast.json", json.dumps(old))
        out = self.expect(OK, "bench", "builtin:spheres", *TINY, "--compare", "fast.json")
        self.assertIn("* beyond the noise", out)
        self.assertRegex(out, r"frame on the device .* \*\n")
        compare = ["bench", "builtin:spheres", *TINY, "--compare", "fast.json", "--fail-above"]
        self.expect(DIFFERS, *compare, "2", says="times what it took")
        self.expect(OK, *compare, "1e9")

    def test_comparisons_that_cannot_be(self):
        self.expect(MISSING, "bench", "builtin:spheres", *TINY, "--compare", "none.json", says="none.json")
        self.write("old.json", '{"scenes": [{"scene": 1}]}')
        self.expect(INVALID, "bench", "builtin:spheres", *TINY, "--compare", "old.json", says="measure again")
        self.write("other.json", '{"scenes": []}')
        self.expect(USAGE, "bench", "builtin:spheres", *TINY, "--compare", "other.json", says="no scene")

    def test_a_sweep_tells_growth_as_text_json_and_csv(self):
        sweep = ["bench", "--sweep", "instances", "--points", "1,4,16", *TINY]
        self.assertRegex(self.expect(OK, *sweep, "--json", "s.json", "--csv", "s.csv"), r"gbuffer .*\+-")
        written = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(written["sweep"]["x"], [1, 4, 16])
        self.assertEqual([scene["scene"] for scene in written["scenes"]][2], "builtin:knots?instances=16")
        rows = {row["name"]: row for row in csv.DictReader((self.folder / "s.csv").read_text().splitlines())}
        self.assertGreater(float(rows["frame on the device"]["16"]), 0)
        self.assertGreater(float(rows["gbuffer"]["growth"]), 0)

    def test_a_sweep_of_an_option_sets_it(self):
        bench = json.loads(self.expect(OK, "bench", "builtin:boxes", "--sweep", "sun_shadows.size", "--points", "256,512", *TINY,
                                       "--json", "-"))
        self.assertEqual(bench["sweep"]["x"], [256, 512])
        maps = [{m["name"]: m["bytes"] for m in scene["shadow_maps"]} for scene in bench["scenes"]]
        self.assertEqual(4 * maps[0]["sun_shadows.cascades"], maps[1]["sun_shadows.cascades"])

    def test_a_sweep_of_resolution_keeps_the_shape(self):
        bench = json.loads(self.expect(OK, "bench", "builtin:spheres", "--sweep", "resolution", "--points", "16,32", *TINY,
                                       "--json", "-"))
        self.assertEqual([(scene["width"], scene["height"]) for scene in bench["scenes"]], [(24, 16), (48, 32)])
        self.assertEqual(bench["sweep"]["intervals"][0]["standard_error"], None)   # two points leave none


class Usage(CliTest):
    def test_lists(self):
        self.assertIn("builtin:spheres", self.expect(OK, "bench", "--list").split())
        self.assertIn("builtin:terrain", self.expect(OK, "bench", "quick", "--list").split())
        self.assertEqual(self.expect(OK, "bench", "--sweep", "lights", "--points", "1,2", "--list").split(),
                         ["builtin:atrium?sun=off&lights=1", "builtin:atrium?sun=off&lights=2"])

    def test_flags_that_need_others(self):
        self.expect(USAGE, "bench", "--points", "1,2", says="--sweep")
        self.expect(USAGE, "bench", "--csv", "a.csv", says="--sweep")
        self.expect(USAGE, "bench", "--fail-above", "1.1", says="--compare")
        self.expect(USAGE, "bench", "--sweep", "weight", says="triangles")
        self.expect(USAGE, "bench", "--sweep", "sun_shadows.cascades", says="--points")
        self.expect(USAGE, "bench", "--sweep", "sun_shadows.cascades", "--points", "1,99", *TINY, says="99")
        self.expect(USAGE, "bench", "--sweep", "lights", "--points", "2,1", says="rise")
        self.expect(USAGE, "bench", "--sweep", "lights", "builtin:spheres", says="scene of its own")
        self.expect(NOT_WRITTEN, "bench", "--sweep", "lights", "--csv", "nowhere/a.csv", says="no folder")

    def test_parameters_of_scenes(self):
        self.expect(USAGE, "info", "builtin:knots?instances=0", says="instances=1..65536")
        self.expect(USAGE, "info", "builtin:spheres?x=1", says="none")
        info = json.loads(self.expect(OK, "info", "builtin:knots?instances=7", "--json"))
        self.assertEqual(info["parameters"][0]["value"], 7)
        self.assertEqual(info["nodes"], 9)   # a ground and a camera besides


if __name__ == "__main__":
    main()

"""The arithmetic of the comparison with other renderers, which needs none of them."""

import pathlib
import struct
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench" / "peers"))
import linear_light
import table


def run(seconds, megabytes, frame_ms=None):
    return {"seconds": seconds, "peak_bytes": megabytes * 1e6, "frame_ms": frame_ms}


class Table(unittest.TestCase):
    def test_medians_leave_outliers_out(self):
        one = table.summary([run(1, 10, 5), run(100, 30, 7), run(2, 20, 6)])
        self.assertEqual((one["seconds"], one["peak_bytes"], one["frame_ms"]), (2, 20e6, 6))
        self.assertIsNone(table.summary([run(1, 10)])["frame_ms"])

    def test_rows_hold_ratios_to_the_base(self):
        rows = table.markdown({"velarium": [run(2, 100, 50)], "other": [run(5, 250)], "third": [run(1, 50, 25)]},
                              {"velarium": 0.0514, "third": None}).splitlines()
        self.assertEqual(rows[2], "| velarium | 2.00 | 1.00 | 50.0 | 1.00 | 100 | 1.00 | 0.051 |")
        self.assertEqual(rows[3], "| other | 5.00 | 2.50 | - | - | 250 | 2.50 | - |")
        self.assertEqual(rows[4], "| third | 1.00 | 0.50 | 25.0 | 0.50 | 50 | 0.50 | - |")

    def test_without_the_base_there_are_no_ratios(self):
        self.assertEqual(table.markdown({"other": [run(5, 250)]}, {}).splitlines()[2], "| other | 5.00 | - | - | - | 250 | - | - |")


class Speed(unittest.TestCase):
    def traced(self, samples, cpu_seconds, tracing_seconds=2.0, seconds=8.0):
        return {"samples": samples, "cpu_seconds": cpu_seconds, "tracing_seconds": tracing_seconds, "seconds": seconds,
                "peak_bytes": 5e6}

    def test_what_is_not_tracing_cancels_out_of_processor_time(self):
        one = table.speed(self.traced(2, 10.0), self.traced(8, 13.0), (1000, 500))
        self.assertAlmostEqual(one["cpu_rate"], 1.0)      # 6 paths through half a million pixels in 3 s
        self.assertAlmostEqual(one["wall_rate"], 2.0)     # 8 of them in 2 s
        self.assertAlmostEqual(one["process_rate"], 0.5)  # and in the 8 s of the process

    def test_no_rate_is_made_up_where_noise_hid_the_work(self):
        with self.assertRaises(ValueError):
            table.speed(self.traced(2, 10.0), self.traced(8, 9.0), (10, 10))

    def test_cycles_tells_of_its_tracing_alone(self):
        log = "Time (in seconds):\n                Wall      Average\n   Path Tracing   7.313934   1.828483\n"
        self.assertEqual(table.cycles_seconds(log), 7.313934)
        with self.assertRaises(ValueError):
            table.cycles_seconds("Blender quit")

    def test_equal_time_goes_by_the_median_of_pairs(self):
        ours, theirs = [{"cpu_rate": rate} for rate in (3.0, 2.0, 80.0)], [{"cpu_rate": rate} for rate in (2.0, 1.0, 1.0)]
        self.assertEqual(table.equal_time_samples(8, ours, theirs), 16)

    def test_rows_hold_ratios_of_pairs(self):
        ours = [table.speed(self.traced(2, 0.0), self.traced(8, 3.0), (1000, 500))] * 2
        theirs = [table.speed(self.traced(2, 0.0), self.traced(8, cpu), (1000, 500)) for cpu in (6.0, 3.0)]
        row = table.speed_markdown({"reference": ours, "cycles": theirs}, "cycles").splitlines()[2]
        self.assertEqual(row, "| reference | 2.000 | 1.00 | 1.000 | 1.50 (1.00, 2.00) | 0.500 | 1.00 | 8.0 | 5 |")

    def test_errors_have_ratios(self):
        errors = {"reference": {"samples": 12, "relmse": 0.5, "relmse_rest": 0.01, "flip": 0.02},
                  "cycles": {"samples": 8, "relmse": 0.25, "relmse_rest": 0.02, "flip": 0.02}}
        self.assertEqual(table.error_markdown(errors, "cycles").splitlines()[2],
                         "| reference | 12 | 0.50000 | 2.00 | 0.01000 | 0.50 | 0.02000 | 1.00 |")


def attribute(name, kind, value):
    return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value


def exr(compressed, parts):
    """1 x 17 pixels, so two chunks: R is 0.5 as a half, G and B the row and its double as floats."""
    channels = b"".join(name + b"\0" + struct.pack("<iiii", kind, 0, 1, 1) for name, kind in ((b"B", 2), (b"G", 2), (b"R", 1)))
    header = (attribute(b"channels", b"chlist", channels + b"\0") + attribute(b"compression", b"compression", b"\3") +
              attribute(b"dataWindow", b"box2i", struct.pack("<4i", 0, 0, 0, 16)) + b"\0")
    version = 2 | (linear_light.MULTI_PART if parts > 1 else 0)
    head = struct.pack("<ii", linear_light.MAGIC, version) + header * parts + (b"\0" if parts > 1 else b"")
    chunks = []
    for rows in (range(16), range(16, 17)):
        raw = b"".join(struct.pack("<ffe", 2.0 * row, row, 0.5) for row in rows)
        mixed = raw[0::2] + raw[1::2]
        steps = bytes([mixed[0]] + [(b - a + 128) & 255 for a, b in zip(mixed, mixed[1:])])
        packed = zlib.compress(steps) if compressed and len(rows) > 1 else raw
        chunks.append((struct.pack("<i", 0) if parts > 1 else b"") + struct.pack("<ii", rows[0], len(packed)) + packed)
    first = len(head) + 16
    return head + struct.pack("<QQ", first, first + len(chunks[0])) + b"".join(chunks)


class LinearLight(unittest.TestCase):
    def read(self, data):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.exr"
            file.write_bytes(data)
            return linear_light.read(file)

    def test_parts_and_chunks_are_read(self):
        for compressed in (True, False):
            for parts in (1, 2):
                planes = self.read(exr(compressed, parts))
                self.assertEqual(list(planes["R"]), [0.5] * 17)
                self.assertEqual(list(planes["G"]), [float(row) for row in range(17)])
                self.assertEqual(list(planes["B"]), [2.0 * row for row in range(17)])

    def test_other_files_are_refused(self):
        for data in (b"\x89PNG\r\n\x1a\n", exr(True, 1).replace(b"\1\0\0\0\3", b"\1\0\0\0\4")):
            with self.assertRaises(linear_light.Unreadable):
                self.read(data)

    def test_relative_errors(self):
        flat = {"R": [0.5, 1.0], "G": [0.5, 1.0], "B": [0.5, 1.0]}
        off = {"R": [0.6, 1.0], "G": [0.5, 1.0], "B": [0.5, 1.0]}
        errors = linear_light.relative_squared_errors(off, flat)
        self.assertAlmostEqual(errors[0], 0.01 / 0.26 / 3)
        self.assertEqual(errors[1], 0.0)

    def test_the_worst_are_left_out_by_share(self):
        errors = [1.0] * 998 + [500.0, 900.0]
        self.assertAlmostEqual(linear_light.mean_without_worst(errors, 0.0), 2.398)
        self.assertAlmostEqual(linear_light.mean_without_worst(errors, 0.002), 1.0)


if __name__ == "__main__":
    unittest.main()

"""The arithmetic of the comparison with other renderers, which needs none of them."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench" / "peers"))
import table


def run(seconds, megabytes, frame_ms=None):
    return {"seconds": seconds, "peak_bytes": megabytes * 1e6, "frame_ms": frame_ms}


class Table(unittest.TestCase):
    def test_medians_leave_outliers_out(self):
        one = table.summary([run(1, 10, 5), run(100, 30, 7), run(2, 20, 6)])
        self.assertEqual((one["seconds"], one["peak_bytes"], one["frame_ms"]), (2, 20e6, 6))
        self.assertIsNone(table.summary([run(1, 10)])["frame_ms"])

    def test_rows_hold_ratios_to_the_base(self):
        rows = table.markdown({"velarium": [run(2, 100, 50)], "other": [run(5, 250)], "third": [run(1, 50, 25)]}).splitlines()
        self.assertEqual(rows[2], "| velarium | 2.00 | 1.00 | 50.0 | 1.00 | 100 | 1.00 |")
        self.assertEqual(rows[3], "| other | 5.00 | 2.50 | - | - | 250 | 2.50 |")
        self.assertEqual(rows[4], "| third | 1.00 | 0.50 | 25.0 | 0.50 | 50 | 0.50 |")

    def test_without_the_base_there_are_no_ratios(self):
        self.assertEqual(table.markdown({"other": [run(5, 250)]}).splitlines()[2], "| other | 5.00 | - | - | - | 250 | - |")


if __name__ == "__main__":
    unittest.main()

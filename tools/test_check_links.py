#!/usr/bin/env python3
"""Tests check_links.py on small trees made for the purpose."""

import pathlib
import tempfile
import unittest

import check_links


class CheckLinks(unittest.TestCase):
    def complaints(self, files):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                file = pathlib.Path(root, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            return check_links.check(root)

    def test_files_and_headings_that_exist(self):
        self.assertEqual(self.complaints({
            "README.md": "[a](docs/a.md) [b](docs/a.md#what-it-does) [c](#here) [d](https://example.org/none)\n## Here\n",
            "docs/a.md": "# What it *does*\n[up](../README.md) [folder](.)\n",
            "src/x/README.md": "needs no link to it\n",
        }), [])

    def test_what_does_not_exist_is_told_with_its_line(self):
        self.assertEqual(self.complaints({"a.md": "\n\nsee [b](b.md)\n"}), ["a.md:3: b.md: no such file"])
        self.assertEqual(self.complaints({"a.md": "# One\n[x](#two)\n"}), ["a.md:2: #two: no such heading"])

    def test_headings_of_one_text_are_numbered(self):
        self.assertEqual(self.complaints({"a.md": "# Cost\n# Cost\n[x](#cost-1)\n"}), [])
        self.assertEqual(len(self.complaints({"a.md": "# Cost\n[x](#cost-1)\n"})), 1)

    def test_code_holds_no_links(self):
        self.assertEqual(self.complaints({"a.md": "`[a](b.md)`\n```\n[c](d.md)\n# Not a heading\n```\n"}), [])

    def test_pictures_are_shown_somewhere(self):
        files = {"a.md": "![p](docs/images/p.png)\n", "docs/images/p.png": ""}
        self.assertEqual(self.complaints(files), [])
        files["docs/images/sub/q.png"] = ""
        self.assertEqual(self.complaints(files), ["docs/images/sub/q.png: no page shows it"])

    def test_pages_of_the_documentation_are_led_to(self):
        self.assertEqual(self.complaints({"docs/a.md": "alone\n"}), ["docs/a.md: no page leads to it"])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""Checks that links of the Markdown pages lead somewhere: files that exist, and headings that their page has. Some page
leads to each page of docs/, and shows each picture of docs/images.

usage: check_links.py [ROOT]

Prints one line a finding, and exits with 1 where there is any. Addresses with a scheme (https:) are not followed.
"""

import os
import pathlib
import re
import sys
import urllib.parse

SKIPPED_FOLDERS = {"build", ".git", ".cache"}
PAGES = "docs"
PICTURES = "docs/images"
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)")
HEADING = re.compile(r"^#{1,6} +(.+?) *#*$", re.MULTILINE)


def pages(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(set(folders) - SKIPPED_FOLDERS)
        for name in sorted(names):
            if name.endswith(".md"):
                yield pathlib.Path(folder, name)


def without_code(text):
    """Lines keep their numbers."""
    return CODE.sub(lambda code: "\n" * code.group().count("\n"), text)


def anchors(page):
    """Of headings, as GitHub makes them: lower case, letters, digits and hyphens, repeated ones numbered."""
    found = {}
    for heading in HEADING.findall(re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        count = found[name] = found.get(name, -1) + 1
        if count:
            found[f"{name}-{count}"] = 0
    return found


def complaint(page, target):
    """What is wrong with a link, or None. Also the file it leads to."""
    address, _, anchor = urllib.parse.unquote(target).partition("#")
    file = (page.parent / address).resolve() if address else page
    if not file.exists():
        return "no such file", file
    if anchor and file.suffix == ".md" and anchor not in anchors(file):
        return "no such heading", file
    return None, file


def check(root):
    root = pathlib.Path(root).resolve()
    lines, reached = [], set()
    for page in pages(root):
        text = without_code(page.read_text(encoding="utf-8"))
        for link in LINK.finditer(text):
            if re.match(r"[a-z][a-z0-9+.-]*:", link.group(1)):
                continue
            wrong, file = complaint(page, link.group(1))
            reached.add(file)
            if wrong:
                number = text.count("\n", 0, link.start()) + 1
                lines.append(f"{page.relative_to(root)}:{number}: {link.group(1)}: {wrong}")
    for folder, pattern, finding in ((PAGES, "*.md", "no page leads to it"), (PICTURES, "*.*", "no page shows it")):
        for file in sorted((root / folder).rglob(pattern)):
            if file not in reached:
                lines.append(f"{file.relative_to(root)}: {finding}")
    return lines


def main():
    lines = check(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    for line in lines:
        print(line)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""errors.py ROOT: docs/errors.md has a row for each enumerator of each error, with its value where it says one, and no other.

Each table is named by a line `<!-- enum: FILE NAME -->`; the names stand in its first column. Every enumeration in the headers
whose name ends in errc, error_code, abort_code or status must have a table.
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
document = (root / "docs/errors.md").read_text(encoding="utf-8")
problems = []


def enumerators(file, name):
    """Names and values."""
    text = re.sub(r"//.*", "", (root / file).read_text(encoding="utf-8"))
    found = re.search(rf"enum class {name} : [\w:]+ \{{(.*?)\}};", text, re.S)
    if not found:
        problems.append(f"{file} has no enumeration {name}")
        return {}
    values = {}
    value = 0
    for item in filter(None, map(str.strip, found[1].split(","))):
        one, _, given = map(str.strip, item.partition("="))
        value = int(given, 0) if given else value
        values[one] = value
        value += 1
    return values


tables = re.findall(r"<!-- enum: (\S+) (\S+) -->\n\n((?:\|.*\n)+)", document)
for file, name, table in tables:
    known = enumerators(file, name)
    listed = {}
    for row in table.splitlines()[2:]:
        for one, value in re.findall(r"`(\w+)`(?: ([0-9A-F]+h|\d+))?", row.split("|")[1]):
            if one in listed:
                problems.append(f"{name}::{one} stands there twice")
            listed[one] = value
    problems += [f"{name}::{one} ({file}) has no row in docs/errors.md" for one in known if one not in listed]
    problems += [f"{name} has no {one}, which docs/errors.md lists" for one in listed if one not in known]
    problems += [f"{name}::{one} is not {value}" for one, value in listed.items() if value and one in known and
                 known[one] != (int(value[:-1], 16) if value.endswith("h") else int(value))]

named = {(file, name) for file, name, _ in tables}
for folder in "include", "schemas":
    for path in sorted((root / folder).rglob("*.hpp")):
        file = path.relative_to(root).as_posix()
        for name in re.findall(r"^enum class (\w*(?:errc|error_code|abort_code|status_code|_status)) ",
                               path.read_text(encoding="utf-8"), re.M):
            # What a message reports of a mission or a component is no error of the library.
            if (file, name) not in named and not file.startswith("schemas/jauscat/schema/jaus/"):
                problems.append(f"{name} ({file}) has no table in docs/errors.md")

print("\n".join(problems) or f"{len(tables)} enumerations, all in docs/errors.md")
sys.exit(bool(problems))

#!/usr/bin/env python3
"""prepare.py ROOT OUT: copies headers and documents for Doxygen, each as headers.py and documents.py make it."""
import pathlib
import sys

sys.dont_write_bytecode = True

import documents
import headers

root, out = map(pathlib.Path, sys.argv[1:3])
sys.path.append(str(root / "docs/model"))
import generate # noqa: E402


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


for folder in "include", "schemas":
    for path in sorted((root / folder).rglob("*.hpp")):
        name = path.relative_to(root).as_posix()
        if "/detail/" not in name:
            write(out / name, headers.prepared(path.read_text(encoding="utf-8")))
try:
    for name, text in documents.prepared(root):
        write(out / name, text)
except ValueError as problem: # a document
    sys.exit(str(problem))
for name, source in generate.pictures(root):
    write(out / "pictures" / f"{name}.dot", source)
for path in sorted((root / "docs/model").glob("*.puml")):
    write(out / "pictures" / path.name, path.read_text(encoding="utf-8"))
# Doxygen shows pages in the order in which it is given them.
write(out / "pages.txt", " ".join(map(documents.file_name, documents.pages(root))) + "\n")

#!/usr/bin/env python3
"""prepare.py ROOT OUT: copies the headers for Doxygen, each as headers.py makes it."""
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True

import headers

root, out = map(pathlib.Path, sys.argv[1:3])
for folder in "include", "schemas":
    for path in sorted((root / folder).rglob("*.hpp")):
        name = path.relative_to(root).as_posix()
        if "/detail/" not in name:
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            (out / name).write_text(headers.prepared(path.read_text(encoding="utf-8")), encoding="utf-8")
shutil.copy(root / "docs/doxygen/main.md", out / "main.md")

#!/usr/bin/env python3
"""assemble.py MODULE OUTPUT: makes one HTML file of page.html, page.css, page.js, live.js and the compressed module.

MODULE "-": without a module, as programs have the page inside. It has the live view only."""
import base64
import gzip
import pathlib
import sys

here = pathlib.Path(__file__).parent


def main(module, output):
    packed = "" if module == "-" else base64.b64encode(gzip.compress(pathlib.Path(module).read_bytes(), 9, mtime=0)).decode()
    page = (here / "page.html").read_text()
    for mark, content in (("/* page.css */", (here / "page.css").read_text()), ("/* module */", packed),
                          ("/* page.js */", (here / "page.js").read_text()), ("/* live.js */", (here / "live.js").read_text())):
        if page.count(mark) != 1:
            sys.exit(f"page.html has not one place for {mark}")
        page = page.replace(mark, content)
    pathlib.Path(output).write_text(page)
    print(f"{output}: {len(page) / 1e6:.2f} MB")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])

#!/usr/bin/env python3
"""prepare.py ROOT OUT: writes the documents into OUT/pages, as documents.py makes them, with the sources of their pictures, and
OUT/mkdocs.yml: mkdocs.yml with the navigation, which is that of docs/README.md. Where scripts/web has made the page for the browser,
the first page has a link to a copy of it."""
import json
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True

import documents

root, out = map(pathlib.Path, sys.argv[1:3])
sys.path.append(str(root / "docs/model"))
import generate # noqa: E402


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


pages = out / "pages"
web = root / "build/web/jauscat.html"
try:
    for name, text in documents.prepared(root):
        if name == "README.md" and web.is_file():
            title, rest = text.split("\n", 1)
            text = f"{title}\n\n[Try it in the browser]({web.name}): paste a message, see its bytes and its way to a slave.\n{rest}"
        write(pages / name, text)
except ValueError as problem: # a document
    sys.exit(str(problem))
for name, source in generate.pictures(root):
    write(pages / "pictures" / f"{name}.dot", source)
for path in sorted((root / "docs/model").glob("*.puml")):
    write(pages / "pictures" / path.name, path.read_text(encoding="utf-8"))
for path in [*root.glob("docs/*.svg"), *root.glob("docs/*.png"), *root.glob("docs/messages/**/*.svg"), root / "docs/site/site.css"]:
    copy = pages / (path.relative_to(root) if path.suffix in (".svg", ".png") else path.name)
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, copy)

if web.is_file():
    shutil.copy(web, pages / web.name)

navigation = [{"JausCat": "README.md"}, {"Documents": "docs/README.md"}]
for section, listed in documents.navigation(root):
    navigation.append({section: [{documents.title(root, page): page} for page in listed]})
if len(sys.argv) > 3: # the folder of the API reference
    navigation.append({"API reference": sys.argv[3] + "/index.html"})
config = (root / "docs/site/mkdocs.yml").read_text(encoding="utf-8")
write(out / "mkdocs.yml", config + "nav: " + json.dumps(navigation) + "\n") # JSON is YAML

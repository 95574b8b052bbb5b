#!/usr/bin/env python3
"""site.py SITE: whether every link of the site leads to a page and an anchor that it has, every page can be reached from the first
one, and the search index finds words in the pages that have them."""
import html.parser
import json
import pathlib
import sys
import urllib.parse

site = pathlib.Path(sys.argv[1])
problems = []


class page_parser(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors |= {found.get("id"), found.get("name") if tag == "a" else None}
        for name in "href", "src":
            if tag in ("a", "link", "img", "script") and name in found:
                self.links.append(found[name])


# Doxygen checks its own pages; of these only the first is looked at.
pages = {}
for path in site.rglob("*.html"):
    name = path.relative_to(site).as_posix()
    if not name.startswith("api/") or name == "api/index.html":
        pages[name] = page_parser()
        pages[name].feed(path.read_text(encoding="utf-8"))

leads_to = {}
for name, page in pages.items():
    leads_to[name] = set()
    for link in page.links:
        url = urllib.parse.urlsplit(link)
        if url.scheme or url.netloc or name in ("404.html", "api/index.html"):
            continue
        target = (site / name).parent / urllib.parse.unquote(url.path) if url.path else site / name
        target = target / "index.html" if target.is_dir() else target
        if not target.is_file():
            problems.append(f"{name}: {link} leads to no file")
            continue
        to = target.resolve().relative_to(site.resolve()).as_posix()
        leads_to[name].add(to)
        anchor = urllib.parse.unquote(url.fragment)
        if anchor and to in pages and anchor not in pages[to].anchors and anchor != "__tabbed":
            problems.append(f"{name}: {link} leads to no heading")

reached, front = set(), {"index.html"}
while front:
    reached |= front
    front = {to for name in front for to in leads_to.get(name, ()) if to in pages} - reached
problems += [f"{name}: no link leads to it" for name in pages if name not in reached and name != "404.html"]

found = {}
index = json.loads((site / "search/search_index.json").read_text(encoding="utf-8"))["docs"]
for entry in index:
    if "heartbeat" in (entry["title"] + " " + entry["text"]).lower():
        found.setdefault(entry["location"].partition("#")[0])
for expected in "docs/jaus-node.html", "docs/jaus-concepts.html", "docs/safety.html", "docs/messages/communications.html":
    if expected not in found:
        problems.append(f"a search for heartbeat does not find {expected}, but {', '.join(found)}")
searched = {entry["location"].partition("#")[0] or "index.html" for entry in index}
problems += [f"{name}: search does not know it" for name in pages
             if name not in searched and name not in ("404.html", "api/index.html", "jauscat.html")]

for problem in problems:
    print(problem, file=sys.stderr)
sys.exit(bool(problems))

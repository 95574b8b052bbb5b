"""The documents as MkDocs takes them.

Mermaid becomes Graphviz or PlantUML, marks of the model's pictures become pictures, links to files that are not part of the site
become plain text. Where Markdown on the web and Python-Markdown differ (lists and tables without an empty line before them, the
indent of inner lists), it is written in the form that both take.
"""
import pathlib
import posixpath
import re

import mermaid


def pages(root):
    """In the order of the site."""
    folders = ["docs/*.md", "docs/*/README.md", "docs/messages/*.md", "docs/messages/sae/*.md", "examples/README.md", "tools/README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
    found = [path.relative_to(root).as_posix() for folder in folders for path in sorted(root.glob(folder))]
    return list(dict.fromkeys(["README.md", "docs/README.md"] + found))


def slug(heading, separator):
    """The anchor of a heading, as it is made on the web."""
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", separator)


def title(root, path):
    return re.search(r"^# (.+)$", (root / path).read_text(encoding="utf-8"), re.MULTILINE)[1].replace("`", "")


def navigation(root):
    """(section, its pages), by the tables of docs/README.md; then the pages that stand in none."""
    left = pages(root)
    for section in re.split(r"^## ", (root / "docs/README.md").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        name, _, text = section.partition("\n")
        listed = [posixpath.normpath("docs/" + target) for target in re.findall(r"^\| \[.*?\]\(([^)#]+)\)", text, re.MULTILINE)]
        listed = [target if target.endswith(".md") else target + "/README.md" for target in listed]
        here = [page for page in listed if page in left]
        left = [page for page in left if page not in here]
        if here:
            yield name, here
    yield "Messages", [page for page in left if page.startswith("docs/messages/")]


def document(path, text, known, root):
    """The text of a page, and its pictures as (name, source)."""
    pictures = []
    result = []
    block = None # lines of a mermaid block
    fenced = False
    up = "../" * path.count("/")

    def link(found):
        words, to = found.groups()
        if re.match(r"[a-z]+:", to):
            return found[0]
        file, _, anchor = to.partition("#")
        target = posixpath.normpath(posixpath.join(posixpath.dirname(path), file)) if file else path
        if (root / target / "README.md").is_file():
            target += "/README.md"
        if target not in known:
            return words
        return f"[{words}]({posixpath.relpath(target, posixpath.dirname(path) or '.')}{'#' + anchor if anchor else ''})"

    def picture(words, name):
        return f"![{words}]({up}pictures/{name}.svg)\n"

    for line in text.split("\n"):
        if line == "```mermaid":
            block = []
        elif block is not None and line == "```":
            name = re.sub(r"\W", "_", path.removesuffix(".md")) + f"_{len(pictures) + 1}"
            try:
                pictures.append((name, mermaid.converted(block)))
            except ValueError as problem:
                raise ValueError(f"{path}: {problem}") from problem
            result.append(picture("", name))
            block = None
        elif block is not None:
            block.append(line)
        elif line.startswith("```"):
            fenced = not fenced
            if fenced and line == "```":
                raise ValueError(f"{path}: a block without a language; output of programs is ```text")
            result.append(line)
        elif fenced or line.startswith("<!-- code:"):
            result += [line] if fenced else []
        else:
            if found := re.match(r"(?:<!-- picture: (\w+) -->|\[(\w+)\.puml\]\(\w+\.puml\))$", line):
                line = picture((found[1] or "").replace("_", " "), found[1] or found[2])
            line = "".join(part if i % 2 else re.sub(r"(?<!!)\[((?:[^\]`]|`[^`]*`)+)\]\(([^)\s]+)\)", link, part)
                           for i, part in enumerate(re.split(r"((?<!\[)`[^`]*`(?!\]))", line)))
            line = re.sub(r"^  (- |\d+\. )", r"    \1", line)
            kind = re.match(r"\s*(- |\d+\. |\|)", line)
            before = result[-1] if result else ""
            if kind and before.strip() and not re.match(r"\s*(- |\d+\. |\|)|\s", before):
                result.append("")
            result.append(line)
    return "\n".join(result), pictures


def prepared(root):
    """(path, text) of all pages and of the sources of their pictures."""
    known = pages(root)
    for path in known:
        text, pictures = document(path, (root / path).read_text(encoding="utf-8"), known, root)
        yield path, text
        for name, source in pictures:
            yield f"pictures/{name}.{'puml' if source.startswith('@startuml') else 'dot'}", source

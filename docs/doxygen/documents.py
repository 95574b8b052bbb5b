"""What Doxygen reads in place of a document.

Doxygen 1.9.4 does not know the anchors that the web gives to headings, links between documents with an anchor, nor mermaid.
Here headings get names, links lead to them, mermaid becomes Graphviz or PlantUML; links to files that are not part of the
site become plain text.
"""
import html
import pathlib
import re

import mermaid


def pages(root):
    """In the order of the site."""
    index = (root / "docs/README.md").read_text(encoding="utf-8")
    listed = ["docs/" + target for target in re.findall(r"\]\(([\w-]+\.md)\)", index)]
    folders = ["docs/*.md", "docs/*/README.md", "docs/messages/*.md", "docs/messages/sae/*.md", "examples/README.md", "tools/README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
    found = [path.relative_to(root).as_posix() for folder in folders for path in sorted(root.glob(folder))]
    return list(dict.fromkeys(["README.md", "docs/README.md"] + listed + found))


def page_name(path):
    return "page_" + re.sub(r"\W", "_", path.removesuffix(".md"))


def file_name(path):
    """Doxygen takes every README.md for the main page."""
    return path if path == "README.md" else path.replace("README.md", "overview.md")


def slug(heading):
    """As anchors are made on the web."""
    heading = re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading)
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", "-")


def target_of(path, link):
    """The file that a link in the document `path` leads to."""
    parts = []
    for part in [*pathlib.PurePosixPath(path).parent.parts, *link.split("/")]:
        if part == "..":
            parts.pop()
        elif part not in ("", "."):
            parts.append(part)
    return "/".join(parts)


def document(path, text, known, root):
    """The text of a page, and its pictures as (name, source)."""
    pictures = []
    subpages = set()
    result = []
    block = None # lines of a mermaid block

    def link(found):
        bang, words, to = found.groups()
        if re.match(r"[a-z]+:", to):
            return found[0]
        file, _, anchor = to.partition("#")
        target = target_of(path, file) if file else path
        if bang:
            return f"![{words}]({target.rsplit('/', 1)[-1]})"
        if (root / target).is_dir() and (root / target / "README.md").is_file():
            target += "/README.md"
        if target not in known:
            return words
        words = words.replace('"', "'")
        plain = words.replace("`", "")
        if anchor:
            return f'@ref {page_name(target)}__{anchor} "{plain}"'
        if target == "README.md":
            return '@ref index "' + plain + '"'
        # An index makes the tree at the side.
        parents = {"docs/README.md", *(name for name in known if re.fullmatch(r"docs/[\w-]+/README\.md", name))}
        under = path == "docs/README.md" or target.startswith(path.removesuffix("README.md"))
        if path in parents and under and target not in subpages and target not in ("docs/README.md", path):
            subpages.add(target)
            return f'@subpage {page_name(target)} "{plain}"'
        return f'@ref {page_name(target)} "{plain}"'

    def outside_code(line):
        """Links in what is not `code`."""
        for kept in re.findall(r"!?\[[^\]]*`[^\]]*\]\([^)\s]+\)", line): # code within a link
            line = line.replace(kept, kept.replace("`", ""))
        parts = re.split(r"(`[^`]*`)", line)
        # Doxygen reads a backslash in code as one of its own.
        parts = ["<code>" + html.escape(part.strip("`")).replace("\\", "&#92;") + "</code>"
                 if part.startswith("`") and "\\" in part else part for part in parts]
        return "".join(part if part.startswith(("`", "<code>")) else re.sub(r"(!?)\[([^\]]+)\]\(([^)\s]+)\)", link, part)
                       for part in parts)

    # Doxygen takes the title from the first line only.
    before, found, rest = text.partition("# ") if text.startswith("<!--") else ("", "", text)
    fenced = titled = False
    for line in (found + rest + before).split("\n"):
        if line.startswith("```"):
            if line == "```mermaid":
                block = []
                continue
            if block is not None:
                name = f"{page_name(path)}_{len(pictures) + 1}"
                try:
                    pictures.append((name, mermaid.converted(block)))
                except ValueError as problem:
                    raise ValueError(f"{path}: {problem}") from problem
                result.append(f"![]({name}.svg)")
                block = None
                continue
            fenced = not fenced
            # Doxygen takes the language in braces, and knows but a few.
            line = {"```cpp": "```{.cpp}", "```xml": "```{.xml}", "```": "```"}.get(line, "```{.txt}") if fenced else line
        elif block is not None:
            block.append(line)
            continue
        elif not fenced:
            # Pictures of the model: rendered from sources, or made from the headers.
            if picture := re.match(r"(?:<!-- picture: (\w+) -->|\[(\w+)\.puml\]\(\w+\.puml\))$", line):
                line = f"![{(picture[1] or '').replace('_', ' ')}]({picture[1] or picture[2]}.svg)\n"
            line = outside_code(line)
            if heading := re.match(r"(#+) (.*)$", line):
                name = f"{page_name(path)}__{slug(heading[2])}" if titled else page_name(path)
                line = line if path == "README.md" and not titled else f"{line} {{#{name}}}"
                titled = True
            line = re.sub(r'<img ([^>]*)src="[^"]*/([^"/]+)"', r'<img \1src="\2"', line)
        result.append(line)
    return "\n".join(result), pictures


def prepared(root):
    """(path, text) of all pages and of the sources of their pictures."""
    known = pages(root)
    for path in known:
        text, pictures = document(path, (root / path).read_text(encoding="utf-8"), known, root)
        yield file_name(path), text
        for name, source in pictures:
            yield f"pictures/{name}.{'puml' if source.startswith('@startuml') else 'dot'}", source

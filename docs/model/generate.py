#!/usr/bin/env python3
"""generate.py ROOT OUT: the pictures of the model that are made from the headers, as Graphviz sources.

includes.dot: which module includes which. includes_MODULE.dot: which header of a module includes which, without what follows
from others. classes_MODULE.dot: classes with their public functions, what they hold (a diamond) and what they refer to (an
arrow). `detail` folders are left out. The modules are the rows of the table in docs/architecture.md.
"""
import pathlib
import re
import sys

look = '''    graph [bgcolor=white fontname="Helvetica" fontsize=11 rankdir={direction} nodesep=0.25]
    node [fontname="Helvetica" fontsize=10 shape=box style=filled fillcolor="#eef3fb" color="#7090c0"]
    edge [fontname="Helvetica" fontsize=9 color="#606060" arrowsize=0.7]
'''
most_functions = 14


def may_include(root):
    """For each module of the table in docs/architecture.md, such as `ethercat/master`, the modules that it may include: those of
    its row, and what these may include. `jaus/*` stands for all modules of a folder."""
    text = (root / "docs/architecture.md").read_text(encoding="utf-8")
    table = re.search(r"^\| module \| includes \|.*\n\|[-| ]+\|\n((?:\|.*\n)+)", text, re.M)[1]
    rows = {}
    for line in table.splitlines():
        columns = line.split("|")
        if name := re.search(r"`(.*?)/`", columns[1]):
            rows[name[1]] = re.findall(r"`(.*?)`", columns[2])
    reached = {}
    for name, listed in rows.items(): # a row includes only those above it
        here = set()
        for one in listed:
            named = [other for other in reached if one == other + "/" or one.endswith("/*") and (other + "/").startswith(one[:-1])]
            if not named:
                raise ValueError(f"docs/architecture.md: no row above {name}/ is {one}")
            for other in named:
                here |= {other} | reached[other]
        reached[name] = here
    return reached


def folder_of(module):
    return ("schemas/jauscat/" if module.startswith("schema/") else "include/jauscat/") + module


def picture_name(module):
    return module.replace("/", "_")


def headers(root, folder):
    return {path.relative_to(root / folder.split("/")[0]).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((root / folder).glob("*.hpp"))}


def included(text):
    return re.findall(r"^#include <(jauscat/.*?)>", text, re.M)


def graph(direction, lines):
    return "digraph {\n" + look.format(direction=direction) + "".join(f"    {line}\n" for line in lines) + "}\n"


def module_of(header):
    """Of `jauscat/net/link/detail/bind_udp.hpp` it is `net/link/detail`, of `jauscat/net.hpp` nothing. `impl/` belongs to
    the folder around it, a set of services (`schema/sae/core/`) to that of all sets. `schema/sae/transport/` is a module."""
    folder = header.removeprefix("jauscat/").rpartition("/")[0].removesuffix("/impl")
    return re.sub(r"^(schema/sae\w*)/(?!transport).*", r"\1", folder)


def all_includes(root):
    """(header, included header) of every include line between headers of the library."""
    for base in "include", "schemas":
        for path in sorted((root / base).rglob("*.hpp")):
            for other in included(path.read_text(encoding="utf-8")):
                yield path.relative_to(root / base).as_posix(), other


def modules(root):
    """Modules, each above those that it includes, with the number of include lines between them."""
    allowed = may_include(root)
    counts = {}
    for pair in all_includes(root):
        a, b = (module_of(header).removesuffix("/detail") for header in pair)
        if a != b and a in allowed and b in allowed:
            counts[a, b] = counts.get((a, b), 0) + 1
    return graph("TB", [f'"{picture_name(name)}"' for name in allowed] +
                 [f'"{picture_name(a)}" -> "{picture_name(b)}" [label="{n}"]' for (a, b), n in sorted(counts.items())])


def includes(root, folder):
    texts = headers(root, folder)
    edges = {name: {other for other in included(text) if other in texts and other != name} for name, text in texts.items()}

    def reached(name, seen):
        for other in edges[name]:
            if other not in seen:
                seen.add(other)
                reached(other, seen)
        return seen

    lines = [f'"{pathlib.PurePath(name).stem}"' for name in texts]
    for name in texts:
        indirect = set().union(*(reached(other, set()) for other in edges[name]))
        lines += [f'"{pathlib.PurePath(name).stem}" -> "{pathlib.PurePath(other).stem}"'
                  for other in sorted(edges[name] - indirect)]
    return graph("LR", lines)


def classes_of(text):
    """(name, bases, public functions, declarations of members) of the classes of a header."""
    text = re.sub(r"namespace detail \{.*?\} // namespace detail", "", text, flags=re.S)
    for found in re.finditer(r"^(?:template <.*>\s+)?(?:requires .*\s+)?(class|struct) (?:\[\[.*?\]\] )?(\w+)(?: final)?(?:\s*: ([^{;]*?))? \{\n(.*?)^\};",
                             text, re.M | re.S):
        kind, name, bases, body = found.groups()
        public = kind == "struct"
        functions, members = [], []
        for line in body.split("\n"):
            if access := re.match(r"  (public|private|protected):", line):
                public = access[1] == "public"
            if not re.match(r"    [^\s/}]", line):
                continue
            line = re.sub(r"\[\[.*?\]\]\s*|//.*", "", line).strip()
            line = re.sub(r"^template <.*?> (?=\w)", "", line)
            function = re.match(r"(?!using|static_assert|return|friend|requires|template)[\w:<>,&*\s]*?(?<![\w:])(\w+)\(", line)
            if function and function[1] not in (name, "operator", "noexcept", "decltype", "requires", "void", "bool"):
                if public and function[1] not in functions:
                    functions.append(function[1])
            elif not function and re.match(r"[\w:<>,&*\s()]+ \*?&?\w+(\{.*\}|\[.*\]| = .*)?;", line) and \
                    not re.match(r"(using|static constexpr|friend|return|typedef|struct|class|enum)\b", line):
                members.append(line)
        yield name, bases or "", functions, members


def classes(root, folder):
    found = [one for text in headers(root, folder).values() for one in classes_of(text)]
    names = {name for name, *_ in found}
    lines, shown = [], set()
    edges = []
    for name, bases, functions, members in found:
        for base in names & set(re.findall(r"\w+", bases)) - {name}:
            edges.append((name, base, "arrowhead=empty"))
        for member in members:
            kind = re.sub(r"\b\w+(\{.*\}|\[.*\]| = .*)?;$", "", member)
            for other in names & set(re.findall(r"\w+", kind)) - {name}:
                by_reference = re.search(r"[&*]", kind) or "span<" in kind
                edges.append((name, other, "arrowhead=vee style=dashed" if by_reference else
                              "dir=back arrowtail=diamond"))
    shown = {name for name, _, functions, _ in found if functions} & {end for a, b, _ in edges for end in (a, b)} | \
        {name for name, _, functions, _ in found if len(functions) > 1}
    for name, _, functions, _ in found:
        if name in shown:
            listed = functions[:most_functions] + (["..."] if len(functions) > most_functions else [])
            rows = "".join(f"{one}{'()' if one != '...' else ''}\\l" for one in listed)
            lines.append(f'"{name}" [shape=record style="filled" label="{{{name}|{rows}}}"]')
    drawn = {(a, b, how) for a, b, how in edges if a in shown and b in shown}
    lines += sorted(f'"{a}" -> "{b}" [{how}]' for a, b, how in drawn)
    # The others side by side, not in one long column.
    alone = [name for name, *_ in found if name in shown and not any(name in (a, b) for a, b, _ in drawn)]
    lines += [f'"{a}" -> "{b}" [style=invis]' for at, (a, b) in enumerate(zip(alone, alone[1:])) if at % 6 != 5]
    return graph("LR", lines)


def pictures(root):
    """(name, source) of all of them."""
    yield "includes", modules(root)
    for module in may_include(root):
        yield f"includes_{picture_name(module)}", includes(root, folder_of(module))
        if not module.startswith("schema/"):
            yield f"classes_{picture_name(module)}", classes(root, folder_of(module))


if __name__ == "__main__":
    out = pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for picture, source in pictures(pathlib.Path(sys.argv[1])):
        (out / f"{picture}.dot").write_text(source, encoding="utf-8")

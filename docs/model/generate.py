#!/usr/bin/env python3
"""generate.py ROOT OUT: the pictures of the model that are made from the headers, as Graphviz sources.

includes.dot: which room includes which. includes_ROOM.dot: which header of a room includes which, without what follows from
others. classes_ROOM.dot: classes with their public functions, what they hold (a diamond) and what they refer to (an arrow).
Insides (`detail`) are left out.
"""
import pathlib
import re
import sys

rooms = { # folder, and its floor
    "include/jauscat/net": 5, "include/jauscat/net/config": 5, "include/jauscat/net/link": 5, "include/jauscat/net/node": 5,
    "include/jauscat/text": 5, "include/jauscat/esi": 5,
    "include/jauscat/bridge": 4,
    "include/jauscat/jaus/message": 4, "include/jauscat/jaus/large_data": 4, "include/jauscat/jaus/component": 4, "include/jauscat/jaus/events": 4, "include/jauscat/jaus/routing": 4,
    "include/jauscat/ethercat": 4,
    "include/jauscat/ethercat/master": 4, "include/jauscat/ethercat/slave": 4, "include/jauscat/ethercat/hilscher": 4,
    "schemas/jauscat/schema/jaus": 3, "schemas/jauscat/schema/ethercat": 3, "schemas/jauscat/schema/translation": 3,
    "include/jauscat/translate": 2, "include/jauscat/wire": 1,
}
look = '''    graph [bgcolor=white fontname="Helvetica" fontsize=11 rankdir={direction} nodesep=0.25]
    node [fontname="Helvetica" fontsize=10 shape=box style=filled fillcolor="#eef3fb" color="#7090c0"]
    edge [fontname="Helvetica" fontsize=9 color="#606060" arrowsize=0.7]
'''
most_functions = 14


def room_name(folder):
    return folder.split("jauscat/", 1)[1].replace("/", "_")


def headers(root, folder):
    return {path.relative_to(root / folder.split("/")[0]).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((root / folder).glob("*.hpp"))}


def included(text):
    return re.findall(r"^#include <(jauscat/.*?)>", text, re.M)


def graph(direction, lines):
    return "digraph {\n" + look.format(direction=direction) + "".join(f"    {line}\n" for line in lines) + "}\n"


def house(root):
    """Rooms, on their floors, with the number of include lines between them."""
    room_of = {}
    for folder in rooms:
        for path in (root / folder).rglob("*.hpp"):
            room_of[path.relative_to(root / folder.split("/")[0]).as_posix()] = folder
    counts = {}
    for name, folder in room_of.items():
        for other in included((root / folder.split("/")[0] / name).read_text(encoding="utf-8")):
            to = room_of.get(other)
            if to and to != folder:
                counts[folder, to] = counts.get((folder, to), 0) + 1
    lines = []
    for floor in sorted(set(rooms.values()), reverse=True):
        names = " ".join(f'"{room_name(folder)}"' for folder in rooms if rooms[folder] == floor)
        lines.append(f"{{ rank=same; {names} }}")
    # The schemas of the two tables stand on the third floor, and are made of rows of the second.
    for (a, b), n in sorted(counts.items()):
        lines.append(f'"{room_name(a)}" -> "{room_name(b)}" [label="{n}"{"" if rooms[a] >= rooms[b] else " color=red"}]')
    return graph("TB", lines)


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
    yield "includes", house(root)
    for folder in rooms:
        yield f"includes_{room_name(folder)}", includes(root, folder)
        if not folder.startswith("schemas"):
            yield f"classes_{room_name(folder)}", classes(root, folder)


if __name__ == "__main__":
    out = pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for picture, source in pictures(pathlib.Path(sys.argv[1])):
        (out / f"{picture}.dot").write_text(source, encoding="utf-8")

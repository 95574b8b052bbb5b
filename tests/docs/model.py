#!/usr/bin/env python3
"""model.py ROOT: the hand-written views of docs/model name only what exists.

A name with `::` is looked up in the headers of its namespace, a function before "(" of an arrow's text in all headers, a name
with an underscore among these and the programs.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True

root = pathlib.Path(sys.argv[1])
sys.path.append(str(root / "docs/model"))
import generate # noqa: E402

problems = []
declared = {} # namespace: names
everything = set()
for folder in "include", "schemas", "examples", "tools":
    for path in (root / folder).rglob("*.hpp"):
        text = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
        spaces = set(re.findall(r"^namespace (?:jauscat::)?([\w:]+) \{", text, re.M))
        names = set(re.findall(r"\b(?:class|struct|concept|using|enum class) (?:\[\[.*?\]\] )?(\w+)", text)) | set(re.findall(r"\b(\w+)\(", text)) | \
            set(re.findall(r"^    (\w+)(?: = \w+)?,", text, re.M))
        everything |= names
        for space in spaces:
            declared.setdefault(space, set()).update(names)
programs = {path.stem for folder in ("examples", "tools") for path in (root / folder).rglob("*.cpp")}

views = sorted((root / "docs/model").glob("*.puml"))
for view in views:
    text = view.read_text(encoding="utf-8")
    known_alias = set(re.findall(r"\bas (\w+)", text))
    text = re.sub(r"\\n", " ", text)
    text = re.sub(r"^(skinparam|hide|@).*", "", text, flags=re.M)
    for name in set(re.findall(r"\b[a-z]\w*(?:::\w+)+", text)):
        space, _, last = name.partition("::")
        for one in last.split("::"):
            if space != "jauscat" and one not in declared.get(space, set()):
                problems.append(f"{view.name}: there is no {name}")
    for name in set(re.findall(r"(?<![:\w])([a-z]+(?:_[a-z0-9]+)+)(?!::)", text)):
        if name not in everything | programs | known_alias:
            problems.append(f"{view.name}: there is no {name}")
    for name in set(re.findall(r": (\w+)\(", text)):
        if name not in everything:
            problems.append(f"{view.name}: there is no function {name}")

readme = (root / "docs/model/README.md").read_text(encoding="utf-8")
made = dict(generate.pictures(root))
problems += [f"README.md: no picture {name} is made" for name in re.findall(r"<!-- picture: (\w+) -->", readme) if name not in made]
problems += [f"README.md does not show {view.name}" for view in views if f"\n[{view.name}]({view.name})\n" not in readme]

print("\n".join(problems) or f"{len(views)} views and {len(made)} pictures made from the headers")
sys.exit(bool(problems))

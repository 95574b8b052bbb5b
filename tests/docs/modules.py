#!/usr/bin/env python3
"""modules.py ROOT: every header includes only what the table of modules in docs/architecture.md lets it include.

A header belongs to the module whose folder it is in. It may include its own module, the modules of its row, and what these may
include. Headers in a `detail` folder belong to the module around it and include nothing of that module but other details; other
modules include them only if they stand in a subfolder of that module. Headers outside of folders include everything.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True

root = pathlib.Path(sys.argv[1])
sys.path.append(str(root / "docs/model"))
import generate # noqa: E402

allowed = generate.may_include(root)
problems = []
lines = 0
for header, other in generate.all_includes(root):
    lines += 1
    folder, to = generate.module_of(header), generate.module_of(other)
    module, other_module = (re.sub("/(detail|impl)$", "", name) for name in (folder, to))
    if not folder:
        continue # jauscat.hpp, net.hpp
    if other == "jauscat/base/compilation.hpp":
        continue # macros alone
    if module not in allowed:
        problems.append(f"{header}: docs/architecture.md has no module {folder}/")
    elif not to:
        problems.append(f"{header} includes {other}, which includes whole layers")
    elif other_module != module and other_module not in allowed[module]:
        problems.append(f"{header} includes {other}: {module}/ may not include {other_module}/")
    elif folder.endswith("/detail") and to == module:
        problems.append(f"{header} includes {other}: a detail includes nothing of the module that it is a part of")
    elif to.endswith("/detail") and module != other_module and not module.startswith(other_module + "/"):
        problems.append(f"{header} includes {other}, a detail of another module")
problems += [f"docs/architecture.md: there is no folder {generate.folder_of(module)}" for module in allowed
             if not list((root / generate.folder_of(module)).glob("*.hpp"))]

print("\n".join(dict.fromkeys(problems)) or f"{lines} include lines, {len(allowed)} modules")
sys.exit(bool(problems))

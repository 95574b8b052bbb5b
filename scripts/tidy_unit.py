"""tidy_unit.py ARGUMENT...: clang-tidy with these arguments for one source; with a compiler cache, only if it has not yet found the
same source and headers without a warning.
"""
import json
import os
import pathlib
import shlex
import subprocess
import sys

import once

arguments = sys.argv[1:]
command = ["clang-tidy", "--quiet", *arguments]
if "CMAKE_CXX_COMPILER_LAUNCHER" not in os.environ:
    sys.exit(subprocess.run(command).returncode)
if "--" in arguments:
    at = arguments.index("--")
    source, options = arguments[at - 1], arguments[at + 1:]
else:
    source = arguments[-1]
    entries = json.loads(pathlib.Path(arguments[arguments.index("-p") + 1], "compile_commands.json").read_text())
    path = os.path.realpath(source)  # a generated source may not be there yet
    compilation = next(entry for entry in entries if os.path.realpath(entry["file"]) == path)
    os.chdir(compilation["directory"])
    command = ["clang-tidy", "--quiet", "-p", compilation["directory"], *arguments[2:-1], compilation["file"]]
    words = shlex.split(compilation["command"])
    words = words[next(i for i, word in enumerate(words) if pathlib.Path(word).name.startswith("clang")) + 1:]
    output = words.index("-o")
    options = [word for word in words[:output] + words[output + 2:] if word not in ("-c", compilation["file"])]
    source = compilation["file"]
sys.exit(once.run(command, [os.path.join(once.root, ".clang-tidy")], ["clang++"],
                  list_command=["clang++", *options, "-M", source]))

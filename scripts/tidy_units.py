"""tidy_units.py BUILD FOLDER SOURCE...: arguments of clang-tidy that check the SOURCEs, a line for each process.

Most of clang-tidy's time goes into the headers that a source includes. So programs of one source are checked several at once:
each in a namespace of its own, after the headers of all. Other sources are checked alone, and those that specialise a template
or include on a condition. BUILD has compile_commands.json; the units are written to FOLDER.
"""
import json
import pathlib
import re
import shlex
import sys

most = 8  # sources of one unit: as many processes as a machine has processors shall have something to do

build, folder, *sources = sys.argv[1:]
commands = {entry["file"]: entry["command"] for entry in json.loads(pathlib.Path(build, "compile_commands.json").read_text())}
alone = re.compile(r"^template <.*> (struct|constexpr).* jauscat::|^namespace [a-z:_]+ \{|^# +include", re.MULTILINE)
program = re.compile(r"^int main\(", re.MULTILINE)
separate = "-DJAUSCAT_SEPARATE_COMPILATION"
groups = {True: [], False: []}  # whether it links jauscat::compiled
for source in map(str, map(pathlib.Path.absolute, map(pathlib.Path, sources))):
    text = pathlib.Path(source).read_text()
    if program.search(text) and not alone.search(text):
        groups[separate in commands[source]].append(source)
    else:
        print("-p", build, source)


def options(members):
    """The options that the members need to compile: macros, folders of headers, warnings, the standard."""
    words = [word for source in members for word in shlex.split(commands[source].replace("-isystem ", "-isystem"))]
    return sorted({word for word in words if re.match("-[DIW]|-isystem|-std=", word)} - {"-Werror"})


pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
count = 0
for members in groups.values():
    for first in range(0, len(members), most):
        together = members[first:first + most]
        lines = []
        for source in together:
            path = pathlib.Path(source)
            for line in re.findall(r"^#include .*", path.read_text(), re.MULTILINE):
                quoted = re.search(r'"(.+)"', line)
                if quoted and (path.parent / quoted[1]).exists():
                    line = f'#include "{path.parent / quoted[1]}"'
                if line not in lines:
                    lines.append(line)
        lines += [f'namespace program_{number} {{\n#include "{source}"\n}}' for number, source in enumerate(together)]
        count += 1
        unit = pathlib.Path(folder, f"unit_{count}.cpp").absolute()
        unit.write_text("\n".join(lines) + "\n")
        print("--checks=-bugprone-suspicious-include", unit, "--", shlex.join(options(together)), "-Wno-return-type")

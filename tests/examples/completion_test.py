#!/usr/bin/env python3
"""completion_test.py GENERATOR PROGRAM...: whether the shells complete what each PROGRAM has by its --help: all options, and the values
that it lists. zsh only reads the file; a shell that is not there is left out."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

generator, *programs = sys.argv[1:]
values = {"jausdump": {"--format": ["json", "text"], "--translate": ["seed", "self-contained"],
                       "--time": ["absolute", "delta", "none", "relative"],
                       "--sort": ["age", "code", "count", "message", "rate", "source"]},
          "communicator": {"--type": ["operator", "other", "vehicle"], "--log-format": ["json", "text"]},
          "jauscat-esi": {"--index-base": ["0x2000", "0x6900", "6900"]}}
wrong = []


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def in_bash(file, name, *words):
    """What the function of `file` completes behind `words`, of which the last may be begun."""
    quoted = " ".join(f"'{word}'" for word in (name, *words))
    return output("bash", "-c", f'source {file}; COMP_WORDS=({quoted}); COMP_CWORD={len(words)}; "$(complete -p {name} |'
                                " sed 's/.*-F \\([^ ]*\\).*/\\1/')\"; printf '%s\\n' \"${COMPREPLY[@]}\"").split()


def in_fish(file, *words):
    line = " ".join(words)
    return [one.split("\t")[0] for one in output("fish", "--no-config", "-c", f"source {file}; complete -C '{line}'").splitlines()]


def check(what, found, expected):
    if sorted(found) != sorted(expected):
        wrong.append(f"{what}: {sorted(found)}, and the help has {sorted(expected)}")


with tempfile.TemporaryDirectory() as folder:
    for program in programs:
        name = pathlib.Path(program).name
        shown = output(program, "--help").split("ptions:\n")[-1]
        options = re.findall(r"^  (?:-\w \[ )?(--[\w-]+)", shown, re.MULTILINE)
        if len(options) < 4:
            wrong.append(f"{name}: its help has only the options {options}")
        files = {}
        for shell in "bash", "zsh", "fish":
            files[shell] = pathlib.Path(folder) / f"{name}.{shell}"
            files[shell].write_text(output(generator, program, shell))
        check(f"{name} in bash", in_bash(files["bash"], name, "--"), options)
        for option, words in values.get(name, {}).items():
            check(f"{name} {option} in bash", in_bash(files["bash"], name, option, ""), words)
        if name == "jauscat-ecat":
            check(f"{name} in bash", in_bash(files["bash"], name, "s"), ["scan", "state", "sdos", "sii"])
        if shutil.which("zsh"):
            output("zsh", "-n", str(files["zsh"]))
        if shutil.which("fish"):
            check(f"{name} in fish", in_fish(files["fish"], name, "--"), options)
            for option, words in values.get(name, {}).items():
                check(f"{name} {option} in fish", in_fish(files["fish"], name, option, ""), words)
for problem in wrong:
    print(problem, file=sys.stderr)
sys.exit(bool(wrong))

#!/usr/bin/env python3
"""once.py [--key FILE] [--program NAME] [--depfile FILE] [--list COMMAND... --] COMMAND...

Runs COMMAND unless it has succeeded before with the same inputs, also in another checkout on this machine: for checks that a
compiler cache does not know, because they compile nothing. A failure is never remembered.

The inputs are the words of the command, its program and those of --program, the files of --key, and the files that --depfile names
after the run or that the command of --list prints as a rule for make (such as "c++ -M source.cpp"). Paths inside the checkout count relative to it.
What is known is in $XDG_CACHE_HOME/jauscat (~/.cache/jauscat).

  once.py --list g++ -M a.cpp -- g++ -fsyntax-only a.cpp
  once.py --depfile a.d -- g++ -fsyntax-only -MD -MF a.d a.cpp
"""
import argparse
import contextlib
import functools
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

root = str(pathlib.Path(__file__).resolve().parents[1])
place = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache", "jauscat")
most_results = 8  # of one command: as many states of its inputs are remembered
longest_unused = 30 * 24 * 3600  # seconds


def relative(text):
    return text.replace(root, "{root}")


@functools.cache
def content(path):
    """The sum of a file; paths inside the checkout count relative to it."""
    try:
        return hashlib.sha256(pathlib.Path(path).read_bytes().replace(root.encode(), b"{root}")).hexdigest()
    except OSError:
        return None


def identity(program):
    path = shutil.which(program)
    if path is None:
        return program
    state = os.stat(path)
    return f"{os.path.realpath(path)} {state.st_size} {state.st_mtime_ns}"


def files_of(rule):
    """The files behind the colon of a rule for make, absolute."""
    words = rule.replace("\\\n", " ").split(": ", 1)[-1].replace("\\ ", "\0").split()
    return sorted({os.path.normpath(os.path.join(os.getcwd(), word.replace("\0", " "))) for word in words})


def run(command, key_files=(), programs=(), depfile=None, list_command=None):
    """The exit code of the command, 0 if it has succeeded before with the same inputs."""
    parts = [relative(word) for word in command]
    parts += [identity(program) for program in (command[0], *programs)]
    parts += [str(content(path)) for path in key_files]
    entry = place / hashlib.sha256("\0".join(parts).encode()).hexdigest()
    try:
        results = json.loads(entry.read_text())
    except (OSError, ValueError):
        results = []
    for result in results:
        if all(content(path.replace("{root}", root)) == known for path, known in result["files"].items()):
            if depfile:
                names = " ".join(path.replace("{root}", root).replace(" ", "\\ ") for path in result["files"])
                pathlib.Path(depfile).write_text(f"{result['target'].replace('{root}', root)}: {names}\n")
            os.utime(entry)
            return 0

    code = subprocess.run(command).returncode
    if code != 0:
        return code
    if depfile:
        rule = pathlib.Path(depfile).read_text()
    else:
        rule = subprocess.run(list_command, capture_output=True, text=True, check=True).stdout
    files = {relative(path): content(path) for path in files_of(rule)}
    result = {"target": relative(rule.split(": ", 1)[0]), "files": files}
    place.mkdir(parents=True, exist_ok=True)
    forget_unused()
    new = entry.with_suffix(f".{os.getpid()}")
    new.write_text(json.dumps([result] + results[: most_results - 1]))
    new.rename(entry)
    return 0


def forget_unused():
    for path in place.glob("*"):
        with contextlib.suppress(FileNotFoundError):  # another process has renamed or removed it
            if path.stat().st_mtime < time.time() - longest_unused:
                path.unlink()


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--key", action="append", default=[])
    parser.add_argument("--program", action="append", default=[])
    parser.add_argument("--depfile")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("commands", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    command = options.commands
    list_command = None
    if options.list:
        if "--" not in command:
            parser.error("--list COMMAND... ends with --")
        at = command.index("--")
        list_command, command = command[:at], command[at + 1:]
    if command[:1] == ["--"]:
        command = command[1:]
    if not command or (options.depfile is None) == (list_command is None):
        parser.error("a command, and either --depfile or --list")
    return run(command, options.key, options.program, options.depfile, list_command)


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""completion.py PROGRAM SHELL: the completion of a program's commands, options and values for bash, zsh or fish, on standard output.

It is made of what PROGRAM prints for --help, which the program makes of the table of its options: an option that the table has is
completed. A value is completed where the option's description lists the words, "text or json", or begins with a file or folder.

Examples:
  completion.py build/release/bin/jausdump bash >/usr/share/bash-completion/completions/jausdump
  completion.py build/release/bin/jausdump zsh >/usr/share/zsh/vendor-completions/_jausdump
  completion.py build/release/bin/jausdump fish >/usr/share/fish/vendor_completions.d/jausdump.fish
"""
import dataclasses
import pathlib
import re
import subprocess
import sys


@dataclasses.dataclass
class option:
    short: str
    name: str
    takes_value: bool
    text: str

    @property
    def words(self):
        """The values that the description lists."""
        word = r"[\w.-]+(?: \([^)]*\))?"
        found = re.search(rf"(?:^|: |\btable )({word}(?:, {word})* or {word})", self.text) if self.takes_value else None
        listed = re.split(r", | or ", re.sub(r" \([^)]*\)", "", found[1])) if found else []
        return listed if all(re.fullmatch(r"[\w.-]+", one) for one in listed) else []

    @property
    def is_file(self):
        return self.takes_value and not self.words and re.match(r"(\w+ )?(file|folder)\b", self.text) is not None


def parsed(help_text):
    """(commands as (name, text), options) of a help text."""
    commands, options, section = [], [], ""
    for line in help_text.splitlines():
        if heading := re.match(r"(\w[\w ]*):$", line):
            section = heading[1]
        elif section == "Commands" and (found := re.match(r"  (\w+) +(\S.*)$", line)):
            commands.append(found.groups())
        elif section.endswith("ptions") and (found := re.match(r"  (?:-(\w) \[ --([\w-]+) \]|--([\w-]+))( arg)?(?: \(=.*?\))? *(.*)$", line)):
            options.append(option(found[1] or "", found[2] or found[3], bool(found[4]), found[5].strip()))
        elif options and section.endswith("ptions") and re.match(r" {8,}\S", line):
            options[-1].text = (options[-1].text + " " + line.strip()).strip()
    return commands, options


def bash(name, commands, options):
    function = "_" + name.replace("-", "_")
    cases = "".join(f"        --{one.name})\n            COMPREPLY=(" +
                    (f"$(compgen -W '{' '.join(one.words)}' -- \"$current\")" if one.words else
                     '$(compgen -f -- "$current")' if one.is_file else "") + ")\n            return ;;\n"
                    for one in options if one.takes_value)
    all_options = " ".join([f"--{one.name}" for one in options] + [f"-{one.short}" for one in options if one.short])
    first = (f"    elif [ \"$COMP_CWORD\" = 1 ]; then\n        COMPREPLY=($(compgen -W '{' '.join(one for one, _ in commands)}' -- \"$current\"))\n"
             if commands else "")
    return f"""# {name}
{function}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
    case $before in
{cases}    esac
    if [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W '{all_options}' -- "$current"))
{first}    else
        COMPREPLY=($(compgen -f -- "$current"))
    fi
}}
complete -o filenames -F {function} {name}
"""


def zsh(name, commands, options):
    def plain(text):
        return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "'\\''")

    lines = []
    for one in options:
        value = ""
        if one.takes_value:
            value = f":{one.name}:" + (f"({' '.join(one.words)})" if one.words else "_files" if one.is_file else " ")
        names = f"'(-{one.short} --{one.name})'{{-{one.short},--{one.name}{'=' if value else ''}}}" if one.short else f"--{one.name}{'=' if value else ''}"
        lines.append(f"    {names}'[{plain(one.text)}]{value}'")
    if commands:
        listed = " ".join(f'{command}\\:"{plain(text)}"' for command, text in commands)
        lines.append(f"    '1:command:(({listed}))'")
    lines.append("    '*:file:_files'")
    return f"#compdef {name}\n_arguments -s \\\n" + " \\\n".join(lines) + "\n"


def fish(name, commands, options):
    def quoted(text):
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"

    lines = [f"complete -c {name} -n __fish_is_first_token -f -a {command} -d {quoted(text)}" for command, text in commands]
    for one in options:
        value = f" -x -a {quoted(' '.join(one.words))}" if one.words else " -r -F" if one.is_file else " -x" if one.takes_value else ""
        lines.append(f"complete -c {name}{' -s ' + one.short if one.short else ''} -l {one.name}{value} -d {quoted(one.text)}")
    return "\n".join([f"# {name}", *lines]) + "\n"


if __name__ == "__main__":
    shells = {"bash": bash, "zsh": zsh, "fish": fish}
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__.strip())
        sys.exit(0)
    if len(sys.argv) != 3 or sys.argv[2] not in shells:
        sys.exit("completion.py: give a program and one of bash, zsh, fish; see completion.py --help")
    shown = subprocess.run([sys.argv[1], "--help"], capture_output=True, text=True, check=True).stdout
    sys.stdout.write(shells[sys.argv[2]](pathlib.Path(sys.argv[1]).name, *parsed(shown)))

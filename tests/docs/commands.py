#!/usr/bin/env python3
"""commands.py ROOT: the table of commands in docs/safety.md has each command of the standard with the rule of command_rules.hpp."""
import pathlib
import re
import sys
import xml.etree.ElementTree

root = pathlib.Path(sys.argv[1])
standard = {}
for message in xml.etree.ElementTree.parse(root / "tests/data/jaus_ra_3_3.xml").getroot().iter("message"):
    if message.get("class") == "command":
        standard[message.get("code")] = message.get("name")
header = (root / "include/jauscat/jaus/component/command_rules.hpp").read_text(encoding="utf-8")
rules = dict(re.findall(r"\{0x(\w{4}), (\w+)\}", header))
table = re.findall(r"^\| (\w{4})h \| (.+?) \| (\w+) \| (.+?) \|$", (root / "docs/safety.md").read_text(encoding="utf-8"), re.M)

problems = []
for code, name, rule, _ in table:
    if standard.get(code) != name:
        problems.append(f"docs/safety.md: {code}h is {standard.get(code, 'no command of the standard')}, not {name}")
    if rules.get(code) != rule:
        problems.append(f"docs/safety.md: {code}h is {rules.get(code, 'not listed')} in command_rules.hpp, not {rule}")
listed = [code for code, *_ in table]
problems += [f"docs/safety.md: {code}h {name} has no row" for code, name in standard.items() if code not in listed]
problems += [f"docs/safety.md: {code}h has two rows" for code in set(listed) if listed.count(code) != 1]
problems += [f"command_rules.hpp: {code}h {name} has no rule" for code, name in standard.items() if code not in rules]
problems += [f"command_rules.hpp: {code}h is no command of the standard" for code in rules if code not in standard]

print("\n".join(problems) or f"{len(table)} commands, all with the rule of command_rules.hpp")
sys.exit(bool(problems))

#!/usr/bin/env python3
"""Whether docs/log-events.md lists the events that the programs log, and their members: log_events.py ROOT."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
declared = root / "examples/support/event.hpp"
sources = [path for folder in ("examples", "tools") for path in (root / folder).rglob("*.[ch]pp") if path != declared]
texts = {path: path.read_text() for path in sources}
used = {name for text in texts.values() for name in re.findall(r"\bevents::(\w+)", text)}
literals = {word for text in texts.values() for word in re.findall(r'"(\w+)"', text)}

problems = []
kinds = dict(re.findall(r'inline constexpr event_kind (\w+)\{"(\w+)"\};', declared.read_text()))
problems += [f"event.hpp: {kind} is named {name}" for kind, name in kinds.items() if kind != name]
problems += [f"event.hpp: no program logs {kind}" for kind in kinds if kind not in used]

page = (root / "docs/log-events.md").read_text()
rows = re.findall(r"^\| `(\w+)` \|([^|]*)\|([^|]*)\|[^|]*\|$", page.split("## Events")[1], re.MULTILINE)
listed = [name for name, _, _ in rows]
problems += [f"log-events.md: {name} is not listed" for name in kinds if name not in listed]
problems += [f"log-events.md: there is no event {name}" for name in listed if name not in kinds]
problems += [f"log-events.md: {name} is listed twice" for name in set(listed) if listed.count(name) > 1]

counters = re.findall(r'named_counter\{"([^"]+)"', (root / "include/jauscat/net/link/udp_counters.hpp").read_text())
known = literals | {counter.replace(" ", "_").replace("-", "_") for counter in counters}
known |= set(re.findall(r"\w+_effort_[xyz]", (root / "schemas/jauscat/schema/jaus/platform.hpp").read_text()))
for name, _, members in rows:
    for member in re.findall(r"`(\w+)`", members):
        if member not in known and member not in kinds:
            problems.append(f"log-events.md: no program writes the member {member} of {name}")

print("\n".join(problems))
sys.exit(bool(problems))

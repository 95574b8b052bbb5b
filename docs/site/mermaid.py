"""Mermaid's flowcharts and state diagrams as Graphviz, its sequence diagrams as PlantUML: as much as the documents use."""
import re

look = '''    graph [fontname="Helvetica" fontsize=11]
    node [fontname="Helvetica" fontsize=11 shape=box style="rounded,filled" fillcolor="#eef3fb" color="#7090c0"]
    edge [fontname="Helvetica" fontsize=10 color="#505050"]
'''
node_pattern = re.compile(r'(\w+)(?:\(\[(.*?)\]\)|\["?(.*?)"?\]|\(\("?(.*?)"?\)\)|\("?(.*?)"?\)|\{"?(.*?)"?\})?')
arrow_pattern = re.compile(r'\s*(?:(<?)(--|-\.|==)\s+("[^"]*"|[^">|]+?)\s+(?:-->|\.->|==>)|(<?)(-->|-\.->|==>|---)(?:\|(.*?)\|)?)\s*')


def quoted(text):
    return '"' + text.replace('"', "'").replace("<br/>", r"\n").replace("<br>", r"\n") + '"'


def flowchart(lines):
    direction = lines[0].split()[1].replace("TD", "TB")
    out = ["digraph {", f"    rankdir={direction}", look]
    for line in lines[1:]:
        line = line.strip()
        if not line or line.startswith(("%%", "classDef", "class ", "style ", "linkStyle")):
            continue
        if found := re.match(r'subgraph (\w+)(?:\s*\["?(.*?)"?\])?$', line):
            out += [f"subgraph cluster_{found[1]} {{", f"    label={quoted(found[2] or found[1])}"]
            continue
        if line == "end":
            out.append("}")
            continue
        if line.startswith("direction "):
            continue
        at, before, arrow, text = 0, [], None, ""
        while at < len(line):
            group = []
            while True:
                found = node_pattern.match(line, at)
                if not found:
                    raise ValueError(f"mermaid: '{line}' is not understood at '{line[at:]}'")
                label = next((part for part in found.groups()[1:] if part is not None), None)
                if label is not None:
                    shape = " shape=ellipse style=filled" if found[2] is not None else ""
                    out.append(f"    n_{found[1]} [label={quoted(label)}{shape}]")
                group.append(found[1])
                at = found.end()
                if not (more := re.compile(r"\s*&\s*").match(line, at)):
                    break
                at = more.end()
            for a in before:
                for b in group:
                    out.append(f"    n_{a} -> n_{b} [{arrow}{f' label={quoted(text)}' if text else ''}]")
            before = group
            if at >= len(line):
                break
            found = arrow_pattern.match(line, at)
            if not found:
                raise ValueError(f"mermaid: '{line}' is not understood at '{line[at:]}'")
            kind = found[2] or found[5]
            text = (found[3] or found[6] or "").strip('"')
            arrow = " ".join(filter(None, ["dir=both" if found[1] or found[4] else "", "style=dashed" if "." in kind else "",
                                           "dir=none" if kind == "---" else ""]))
            at = found.end()
    return "\n".join(out + ["}", ""])


def states(lines):
    out = ["digraph {", "    rankdir=LR" if "direction LR" in map(str.strip, lines) else "    rankdir=TB", look]
    for line in map(str.strip, lines[1:]):
        if not line or line.startswith(("direction", "%%")):
            continue
        found = re.match(r"(\w+|\[\*\]) --> (\w+|\[\*\])(?: ?: ?(.*))?$", line)
        if not found:
            raise ValueError(f"mermaid: '{line}' is not understood")
        a = "begin" if found[1] == "[*]" else found[1]
        b = "end" if found[2] == "[*]" else found[2]
        out += [f'    {point} [shape=point label="" width=0.15]' for point in ("begin", "end") if point in (a, b)]
        out.append(f"    {a} -> {b}" + (f" [label={quoted(found[3])}]" if found[3] else ""))
    return "\n".join(out + ["}", ""])


def sequence(lines):
    out = ["@startuml", "hide footbox", "skinparam shadowing false", "skinparam monochrome false"]
    for line in map(str.strip, lines[1:]):
        if found := re.match(r"(participant|actor) (\w+)(?: as (.*))?$", line):
            label = (found[3] or found[2]).replace("<br>", r"\n").replace("<br/>", r"\n")
            line = f'{found[1]} "{label}" as {found[2]}'
        elif found := re.match(r"(\w+)\s*(-?->>?|--?[x)])\s*(\w+)\s*:\s*(.*)$", line):
            arrow = {"->>": "->", "-->>": "-->", "->": "->", "-->": "-->", "-x": "->x", "--x": "-->x"}[found[2]]
            line = f"{found[1]} {arrow} {found[3]} : {found[4]}"
        elif found := re.match(r"Note (over|left of|right of) ([\w,\s]+): ?(.*)$", line):
            line = f"note {found[1]} {found[2]} : {found[3]}"
        elif re.match(r"(alt|else|opt|loop|par|end|activate|deactivate|autonumber)\b", line) or not line:
            pass
        elif line.startswith("%%"):
            continue
        else:
            raise ValueError(f"mermaid: '{line}' is not understood")
        out.append(line.replace("<br>", r"\n"))
    return "\n".join(out + ["@enduml", ""])


def converted(lines):
    kind = lines[0].split()[0]
    if kind in ("flowchart", "graph"):
        return flowchart(lines)
    if kind == "sequenceDiagram":
        return sequence(lines)
    if kind.startswith("stateDiagram"):
        return states(lines)
    raise ValueError(f"mermaid: '{kind}' is not known")

"""What Doxygen reads in place of a header.

The headers document what is particular. Names that mean the same wherever they stand (an item's `put`, a row's `to_packet`, a
range's `min`) have one sentence in conventions.txt, which is put here before each declaration that has no comment of its
own. Lines keep their numbers.
"""
import re


def conventions(path):
    """Lines `FOLDER | NAME | sentence`, the first two regular expressions; the first that matches counts."""
    with open(path, encoding="utf-8") as file:
        lines = [re.split(r"\s*\| +", line.strip(), maxsplit=2) for line in file if line.strip() and line[0] != "#"]
    return [(re.compile(folder), re.compile(name), sentence) for folder, name, sentence in lines]


def without_template(line):
    """The line behind `template <...>`."""
    while line.startswith("template <"):
        depth = 0
        for at, char in enumerate(line):
            depth += (char == "<") - (char == ">" and line[at - 1] != "-")
            if char == ">" and depth == 0:
                break
        line = line[at + 1:].lstrip()
    return line


def declared(line):
    """The name that a line declares, or ''."""
    line = re.sub(r"\[\[.*?\]\]\s*", "", without_template(line.strip()))
    line = without_template(re.sub(r"^(requires .*? )?(JAUSCAT_(PART|WHOLE)|explicit|constexpr|consteval|inline)\s+", "", line))
    if re.match(r"(static_assert|friend (class|struct)|public|private|protected|return|if|for|struct|class|union|enum|concept|[}):])",
                line):
        return ""
    if using := re.match(r"using ([\w:]+)( =|;)", line):
        return using[1].split("::")[-1]
    if operator := re.search(r"(?<!template )\boperator ?(\(\)|\[\]|[^\s\w(]+|bool)", line):
        return "operator" + operator[1]
    if pointer := re.search(r"\(\*(\w+)\)\(", line):
        return pointer[1]
    if function := re.match(r"[^=({]*?(~?\b\w+)\(", line):
        return function[1]
    if variable := re.match(r"[^=({]*?\b(\w+)\s*(=|\{|;|,|\[|$)", re.sub(r"<.*>", "", line)):
        return variable[1]
    return ""


# Ranges of schema/jaus/types.hpp, a line each: the limits are the documentation.
one_line_range = re.compile(
    r"^(struct \w+\s+\{) (?:(static constexpr double) min = (\S.*?),\s+max = (\S.*?)\s*; )?"
    r"(static constexpr std::string_view unit(?:\{\}| = \"(.*?)\"); \};)")


def documented_range(found):
    begin, double, low, high, unit_member, unit = found.groups()
    unit = unit or ""
    what = f"From {low} to {high}{' ' + unit if unit else ''}." if low else f"The unit {unit}."
    limits = f"/** Lowest value. */ {double} min = {low}; /** Highest value. */ {double} max = {high}; " if low else ""
    return f"/** {what} */ {begin} {limits}/** Unit of the values, for text. */ {unit_member}"


def as_file_comment(text):
    """The comment that a header begins with, as that of the file; `#pragma once` gives it a line. Lists and code in it are
    told by their indentation."""
    head, pragma, rest = text.partition("#pragma once\n")
    if not pragma:
        return text
    lines = []
    verbatim = False
    source = head.rstrip("\n").split("\n")
    for at, line in enumerate(source):
        words = line[2:]
        indent = len(words) - len(words.lstrip())
        following = source[at + 1][2:] if at + 1 < len(source) else ""
        if indent > 3:
            begin = "" if verbatim else "@verbatim "
            verbatim = following.startswith("    ")
            lines.append("/// " + begin + words[1:] + ("" if verbatim else " @endverbatim"))
        elif indent > 1:
            lines.append("/// - " + words.lstrip())
        else:
            lines.append("///" + words)
    return "\n".join(lines) + "\n/// @file\n" + rest


def escaped(comment):
    """A comment of plain text: `<` is no HTML, a backslash no command. Code stays as it is."""
    if "@verbatim" in comment or re.match(r"///<? {4,}", comment):
        return comment
    begin, words = re.match(r"(///<?)(.*)", comment).groups()
    parts = re.split(r"(`[^`]*`|@\w+)", words)
    return begin + "".join(part if part.startswith(("`", "@")) else re.sub(r"([<>\\])", r"\\\1", part) for part in parts)


def prepared(path, text, rules):
    def sentence(name):
        if not name:
            return ""
        for folder, pattern, words in rules:
            if folder.search(path) and pattern.fullmatch(name):
                return f"/** {words} */ "
        return ""

    text = as_file_comment(text)
    result = []
    scopes = [0]          # indentation of the members of each scope around
    documented = False    # by a comment above
    waiting = None        # line where a declaration began whose name is not known yet
    verbatim = False
    comparison = False    # within one that takes several lines
    head_indent = None    # of a structure whose bases stand on lines of their own
    for line in text.split("\n"):
        stripped = line.strip()
        indent = len(line) - len(line.lstrip())
        comparison = comparison or re.search(r"friend .*operator==\((.*= default;|[^)]*,$)", line)
        if comparison: # values compare member by member; nothing to look up
            result.append("")
            comparison = documented = not stripped.endswith(";")
            continue
        if stripped.startswith("///"):
            documented, waiting = True, None
        elif not stripped or stripped.startswith(("//", "#")):
            documented, waiting = False, None
        elif found := one_line_range.match(line):
            line, documented = documented_range(found), False
        elif indent == scopes[-1] and "///<" not in line and not documented:
            head = re.match(r"(template <.*>|requires .*)$", stripped) and not without_template(stripped)
            if head or stripped.startswith("requires ") and waiting is not None:
                if waiting is None:
                    waiting = len(result)
            else:
                comment = sentence(declared(line))
                # Doxygen documents the first of a list of constants only.
                if comment and (two := re.match(r"(\s*static constexpr [\w:]+) (\w+ = [^,]+(?:\(.*?\))?), (\w+) = ", line)):
                    line = line.replace(f", {two[3]} = ", f"; {sentence(two[3])}{two[1].strip()} {two[3]} = ", 1)
                if comment and waiting is not None:
                    at = len(result[waiting]) - len(result[waiting].lstrip())
                    result[waiting] = result[waiting][:at] + comment + result[waiting][at:]
                elif comment:
                    line = line[:indent] + comment + line[indent:]
                waiting = None
        elif documented and indent == scopes[-1] and not re.match(r"(template <.*>|requires .*)$", stripped):
            documented = False
        line = re.sub(r"(struct \w+ [^{]*\{) (using (\w+) = [^;]*; \};)", # all in one line
                      lambda found: f"{found[1]} {sentence(found[3])}{found[2]}", line)
        # Doxygen loses the comment behind a pointer to a function, and gives that of several members to the first.
        if pointer := re.match(r"( *)([\w:<> ]+[*&]* ?\(\*\w+\)\(.*\))\{\}; *///< (.*)$", line):
            line = f"{pointer[1]}/** {pointer[3]} */ {pointer[2]};"
        elif several := re.match(r"( *)([\w:<>() ,&*]+?) (\w+\{\}(?:, \w+\{\})+); *(?:///< (.*))?$", line):
            begin, kind, names, comment = several.groups()
            comments = [comment or "", comment or "The same, the other way round."]
            line = begin + " ".join((f"/** {comments[at > 0]} */ " if comments[at > 0] else "") + f"{kind} {name};"
                                    for at, name in enumerate(names.split(", ")))
        if "///" in line:
            code, mark, comment = line.partition("///")
            verbatim = "@endverbatim" not in comment and (verbatim or "@verbatim" in comment)
            line = code + (mark + comment if verbatim else escaped(mark + comment))
        result.append(line)
        if re.match(r"\s*(/\*\*.*?\*/ )?(template <.*> )?(requires\(.*\) )?(struct|class|union) [^;]*\{$", line) or \
                (head_indent is not None and stripped.endswith("{")):
            scopes.append((indent if head_indent is None else head_indent) + 4)
            head_indent, documented = None, False
        elif re.match(r"\s*(template <.*> )?(struct|class) [^;{(]*$", line):
            head_indent = indent
        elif re.match(r"\s*\};?$", line) and len(scopes) > 1 and indent == scopes[-1] - 4:
            scopes.pop()
        elif stripped.endswith(";"):
            head_indent = None
    return "\n".join(result)

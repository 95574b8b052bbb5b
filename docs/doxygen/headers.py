"""What Doxygen reads in place of a header: the same lines, with the comments in Doxygen's form.

The comments are plain text. The comment that a header begins with becomes the description of the file.
"""
import re


def as_file_comment(text):
    """`#pragma once` gives its line to `@file`, so that lines keep their numbers. Indentation marks lists and code."""
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


def prepared(text):
    result = []
    verbatim = False
    for line in as_file_comment(text).split("\n"):
        # Doxygen loses a comment behind a pointer to a function.
        if pointer := re.match(r"( *)([\w:<> ]+[*&]* ?\(\*\w+\)\(.*\))\{\}; *///< (.*)$", line):
            line = f"{pointer[1]}/** {pointer[3]} */ {pointer[2]};"
        if "///" in line:
            code, mark, comment = line.partition("///")
            verbatim = "@endverbatim" not in comment and (verbatim or "@verbatim" in comment)
            line = code + (mark + comment if verbatim else escaped(mark + comment))
        result.append(line)
    return "\n".join(result)

"""chains.py FOLDER...: the headers of the FOLDERs, sorted into as few chains as possible, one a line.

A header includes, directly or not, all that stand before it in its chain. So one source that includes a chain in its order
checks that each header has the includes it needs: what the headers before it have included, it includes, too.
"""
import functools
import pathlib
import re
import sys

sys.setrecursionlimit(10000)
above = re.compile(r"^jauscat/(net|app)[./]")  # compiled with other options than the headers below the I/O line
texts = {}
for folder in map(pathlib.Path, sys.argv[1:]):
    for path in folder.rglob("*.hpp"):
        texts[path.relative_to(folder).as_posix()] = path.read_text()
texts.pop("jauscat/src.hpp", None)  # what jauscat::compiled compiles

# An include that depends on a condition is indented after the #.
included = {header: [name for name in re.findall(r"^#include <([^>]+)>", text, re.MULTILINE) if name in texts]
            for header, text in texts.items()}


@functools.cache
def all_included(header):
    return frozenset(included[header]).union(*(all_included(name) for name in included[header]))


headers = sorted(texts, key=lambda header: (len(all_included(header)), header))
users = {header: [user for user in headers
                  if header in all_included(user) and bool(above.match(header)) == bool(above.match(user))]
         for header in headers}

# The fewest chains: a maximum matching of each header with the next one of its chain.
before = {}


def find_next(header, tried):
    for user in users[header]:
        if user not in tried:
            tried.add(user)
            if user not in before or find_next(before[user], tried):
                before[user] = header
                return True
    return False


for header in reversed(headers):
    find_next(header, set())
for header in headers:
    if header not in before.values():
        chain = [header]
        while chain[-1] in before:
            chain.append(before[chain[-1]])
        print(*reversed(chain), sep=";")

#!/usr/bin/python3
"""mutants_test.py COMPILER: scripts/mutation.py makes mutants of each kind of sample.hpp; all are built at once, and each is switched.

Prints SKIPPED: and the reason where libclang is missing; with CI=true that is a failure.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
here = pathlib.Path(__file__).resolve().parent
sys.path.append(str(here.parents[1] / "scripts"))
try:
    import mutation
except ImportError as problem:
    print(f"SKIPPED: {problem} (python3-clang)")
    sys.exit(os.environ.get("CI") == "true")

unchanged = "100 100 2 8 12 -1 7 3 2 4\n"
# Each mutant with what sample.cpp prints.
expected = {
    "15: comparison shifted: value < limit -> value <= limit": "110 100 2 8 12 -1 7 3 2 4\n",
    "15: return exchanged: return value < limit -> return !(value < limit)": "011 100 2 8 12 -1 7 3 2 4\n",
    "17: return exchanged: return a.x == b.x && a.y == b.y -> return !(a.x == b.x && a.y == b.y)": "100 011 2 8 12 -1 7 3 2 4\n",
    "17: comparison shifted: a.x == b.x -> a.x != b.x": "100 001 2 8 12 -1 7 3 2 4\n",
    "17: operand left out: a.x == b.x -> left out of &&": "100 101 2 8 12 -1 7 3 2 4\n",
    "17: comparison shifted: a.y == b.y -> a.y != b.y": "100 010 2 8 12 -1 7 3 2 4\n",
    "17: operand left out: a.y == b.y -> left out of &&": "100 110 2 8 12 -1 7 3 2 4\n",
    "19: return exchanged: return a - b -> return {}": "100 100 0 8 12 -1 7 3 2 4\n",
    "21: return exchanged: return difference(a, b) -> return {}": "100 100 0 8 12 -1 7 3 2 4\n",
    "21: arguments swapped: difference(a, b) -> difference(b, a)": "100 100 -2 8 12 -1 7 3 2 4\n",
    "24: comparison shifted: given == colour::red -> given != colour::red": "100 100 2 8 21 -1 7 3 2 4\n",
    "24: constant replaced: colour::red -> colour::green": "100 100 2 8 21 -1 7 3 2 4\n",
    "24: constant replaced: colour::green -> colour::blue": "100 100 2 8 22 -1 7 3 2 4\n",
    "25: constant replaced: colour::blue -> colour::red": "100 100 2 8 10 -1 7 3 2 4\n",
    "30: statement left out: result += value; -> left out": "100 100 2 4 12 -1 7 3 2 4\n",
    "31: return exchanged: return result -> return {}": "100 100 2 0 12 -1 7 3 2 4\n",
    "36: comparison shifted: *at > 2 -> *at >= 2": "100 100 2 8 12 -1 2 3 2 4\n",
    "36: condition negated: *at > 2 -> !(*at > 2)": "100 100 2 8 12 1 2 -1 2 4\n",
    "36: constant replaced: 2 -> 2 + 1": "100 100 2 8 12 -1 7 -1 2 4\n",
    "36: return exchanged: return result -> return {}": "100 100 2 8 12 -1 7 -1 2 4\n",
    "37: comparison shifted: value % 2 != 0 -> value % 2 == 0": "100 100 2 8 12 7 -1 3 2 4\n",
    "37: constant replaced: 2 -> 2 + 1": "100 100 2 8 12 -1 -1 3 2 4\n",
    "37: constant replaced: 0 -> 0 + 1": "100 100 2 8 12 7 -1 3 2 4\n",
    "38: return exchanged: return 7 -> return {}": "100 100 2 8 12 -1 -1 3 2 4\n",
    "38: constant replaced: 7 -> 7 + 1": "100 100 2 8 12 -1 8 3 2 4\n",
    "48: return exchanged: return values.size() -> return {}": "100 100 2 8 12 -1 7 3 2 0\n",
    "50: return exchanged: return sizeof(int[2]) -> return {}": unchanged,  # never reached
}
never_reached = 1
# Stands in a constant expression.
refused = ["47: constant replaced: 3 -> 3 + 1"]


def text(one):
    return f"{one.line}: {one.kind}: {one.change}"


def run(program, **environment):
    return subprocess.run([program], env={**os.environ, **environment}, capture_output=True, text=True, timeout=10).stdout


def main():
    failures = []

    def compare(what, found, wanted):
        if found != wanted:
            failures.append(f"{what}:\n  found  {found!r}\n  wanted {wanted!r}")

    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        header = "include/jauscat/sample/sample.hpp"
        (tree / header).parent.mkdir(parents=True)
        shutil.copy(here / "sample.hpp", tree / header)
        shutil.copy(here / "mutant_switch.hpp", tree / "include")
        mutants = mutation.find(tree, "sample")
        for number, one in enumerate(mutants, 1):
            one.number = number
        source = (here / "sample.hpp").read_text()

        def write(those):
            made = mutation.rendered(source, those)
            (tree / header).write_text(made.text)
            return {header: made}

        headers = ["jauscat/sample/sample.hpp"]
        options = ["-DJAUSCAT_MUTANTS_NOT_CONSTANT", "-Wno-invalid-constexpr"]
        bad, _ = mutation.refused(tree, headers, write(mutants), options)
        compare("in constant expressions", [text(one) for one in bad], refused)
        mutants = [one for one in mutants if one not in bad]
        bad, other = mutation.refused(tree, headers, write(mutants))
        compare("errors", [text(one) for one in bad] + other, [])
        compare("mutants", {text(one) for one in mutants}, set(expected))

        program = tree / "sample"
        subprocess.run([sys.argv[1], "-std=c++20", "-Wall", "-Wextra", "-Werror", f"-I{tree}/include", str(here / "sample.cpp"), "-o",
                        str(program)], check=True)
        record = tree / "record"
        compare("without mutants", run(program, JAUSCAT_MUTANT_RECORD=str(record)), unchanged)
        compare("reached", len(record.read_text().split()), len(mutants) - never_reached)
        for one in mutants:
            compare(text(one), run(program, JAUSCAT_MUTANT=str(one.number)), expected.get(text(one)))
    print("\n".join(failures) or f"{len(mutants)} mutants are as expected")
    return int(bool(failures))


if __name__ == "__main__":
    sys.exit(main())

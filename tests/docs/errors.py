#!/usr/bin/env python3
"""errors.py ROOT: docs/errors.md has each enumerator of each error, with its value where it says one, and no other.

Each table is named by a line `<!-- enum: FILE NAME -->`; the names stand in its first column. `x_*` with the first value and
the last is every name of this beginning that has no row of its own. Names that `describe` explains are in EXPLAINED instead.
Every enumeration in the headers whose name ends in errc, error_code, abort_code or status must have a table.
"""
import fnmatch
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
document = (root / "docs/errors.md").read_text(encoding="utf-8")
problems = []

SUCCESS = {"ok", "none", "handled", "accepted"}
# Values to whose text in `describe` the page has nothing to add.
EXPLAINED = {
    "include/jauscat/app/bus_error.hpp bus_errc":
        "not_started no_reply not_sent no_slaves no_such_slave ambiguous too_many_slaves wrong_slave no_objects not_taken refused "
        "malformed_answer wrong_size too_large timed_out not_configurable not_synchronized needs_cycles",
    "include/jauscat/app/error.hpp node_errc":
        "not_running not_encodable not_one_address control_refused already_asked",
    "include/jauscat/net/error.hpp errc": "empty_message invalid_address not_ethernet",
    "include/jauscat/net/config_error.hpp config_errc":
        "unreadable not_xml wrong_root unexpected missing duplicate too_many invalid_value no_such_system",
    "include/jauscat/esi/error.hpp errc":
        "unreadable not_xml not_esi missing unexpected invalid_value duplicate inconsistent",
    "include/jauscat/jsidl/error.hpp errc":
        "unreadable not_xml not_jsidl missing unexpected invalid_value duplicate inconsistent",
    "include/jauscat/text/error.hpp errc":
        "unfinished_escape unfinished_quote not_an_assignment invalid_path index_too_large duplicate missing_name "
        "unknown_message unhandled_message unknown_field missing_field wrong_kind invalid_value out_of_range wrong_size "
        "inconsistent too_deep",
    "include/jauscat/translate/errc.hpp errc": "truncated",
    "include/jauscat/jaus/component/component_outcome.hpp component_outcome": "deferred malformed acknowledgement",
    "include/jauscat/jaus/routing/routed.hpp routed": "no_receiver source_is_elsewhere",
    "include/jauscat/jaus/routing/routed.hpp added": "invalid_address",
    "include/jauscat/jaus/large_data/reassembler.hpp reassembled": "only waiting whole repeated",
    "include/jauscat/ethercat/frame_errc.hpp frame_errc": "too_short not_ethercat",
    "include/jauscat/ethercat/master/master_errc.hpp master_errc":
        "busy timeout sii_busy no_mailbox no_coe state_timeout no_fmmu watchdog_range not_configured toggle_bit "
        "fragment_missing no_space",
    "schemas/jauscat/schema/ethercat/al_state.hpp al_status_code": "controller_available",
}


def enumerators(file, name):
    """Names and values."""
    text = re.sub(r"//.*", "", (root / file).read_text(encoding="utf-8"))
    found = re.search(rf"enum class {name} : [\w:]+ \{{(.*?)\}};", text, re.S)
    if not found:
        problems.append(f"{file} has no enumeration {name}")
        return {}
    values = {}
    value = 0
    for item in filter(None, map(str.strip, found[1].split(","))):
        one, _, given = map(str.strip, item.partition("="))
        value = int(given, 0) if given else value
        values[one] = value
        value += 1
    return values


def number(text):
    return int(text[:-1], 16) if text.endswith("h") else int(text)


VALUE = r"([0-9A-F]+h|\d+)"
tables = re.findall(r"<!-- enum: (\S+) (\S+) -->\n\n((?:\|.*\n)+)", document)
packet_status = enumerators("schemas/jauscat/schema/ethercat/hilscher.hpp", "packet_status")
pairs = (root / "include/jauscat/ethercat/hilscher/packet_status.hpp").read_text(encoding="utf-8")
status_of = dict(re.findall(r"\{abort_code::(\w+), packet_status::(\w+)\}", pairs))
for file, name, table in tables:
    known = enumerators(file, name)
    rows = [row.split("|")[1] for row in table.splitlines()[2:]]
    listed = {}
    for row in rows:
        for one, value, last_byte in re.findall(rf"`(\w+)`(?: {VALUE}(?:/{VALUE})?)?", row):
            if one in listed:
                problems.append(f"{name}::{one} stands there twice")
            listed[one] = value
            if name == "abort_code":
                status = packet_status.get(status_of.get(one))
                expected = "" if status is None else f"{status & 0xFF:02X}h"
                if last_byte != expected:
                    problems.append(f"{name}::{one} has the packet status '{expected}', not '{last_byte}'")
    for row in rows:
        for pattern, first, last in re.findall(rf"`(\w+\*)` {VALUE} to {VALUE}", row):
            these = {one: value for one, value in known.items() if fnmatch.fnmatch(one, pattern) and one not in listed}
            if not these or (min(these.values()), max(these.values())) != (number(first), number(last)):
                problems.append(f"{name}::{pattern} is not {first} to {last}")
            problems += [f"{name}::{one} is between the values of {pattern}, in another row" for one, value in known.items()
                         if number(first) <= value <= number(last) and one not in these and f"`{one}`" not in row]
            listed |= dict.fromkeys(these, "")
    explained = set(EXPLAINED.get(f"{file} {name}", "").split())
    problems += [f"{name}::{one} is in docs/errors.md or not in {file}: EXPLAINED has it" for one in explained
                 if one in listed or one not in known]
    problems += [f"{name}::{one} ({file}) has no row in docs/errors.md" for one in known
                 if one not in listed and one not in SUCCESS and one not in explained]
    problems += [f"{name} has no {one}, which docs/errors.md lists" for one in listed if one not in known]
    problems += [f"{name}::{one} is not {value}" for one, value in listed.items() if value and one in known and
                 known[one] != number(value)]

named = {(file, name) for file, name, _ in tables}
for folder in "include", "schemas":
    for path in sorted((root / folder).rglob("*.hpp")):
        file = path.relative_to(root).as_posix()
        for name in re.findall(r"^enum class (\w*(?:errc|error_code|abort_code|status_code|_status)) ",
                               path.read_text(encoding="utf-8"), re.M):
            # What a message reports of a mission or a component is no error of the library.
            if (file, name) not in named and not file.startswith(
                    ("schemas/jauscat/schema/jaus/", "schemas/jauscat/schema/sae")):
                problems.append(f"{name} ({file}) has no table in docs/errors.md")

print("\n".join(problems) or f"{len(tables)} enumerations, all in docs/errors.md")
sys.exit(bool(problems))

#!/bin/bash
# The tool jauscat-esi as a user runs it: esi_tool.sh TOOL CASE
set -u
tool=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "FAILED: $*" >&2; exit 1; }
# expect CODE ARGS...: runs the tool, and keeps what it says in $work/out and $work/err
expect() {
    local code=$1 got=0
    shift
    "$tool" "$@" >"$work/out" 2>"$work/err" || got=$?
    [ "$got" -eq "$code" ] || fail "$* ended with $got instead of $code: $(cat "$work/err")"
}
says() { grep -qF -- "$1" "$work/out" "$work/err" || fail "'$1' is not in: $(cat "$work/out" "$work/err" | head -50)"; }

writes_and_checks() {
    expect 0 --output "$work/arm.xml"
    [ ! -s "$work/out" ] || fail "it writes to standard output, too"
    if command -v xmllint >"$work/where"; then xmllint --noout "$work/arm.xml" || fail "xmllint refuses it"; fi
    if command -v python3 >"$work/where"; then
        python3 - "$work/arm.xml" <<'PY' || fail "another reader finds something else in it"
import sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
assert root.tag == "EtherCATInfo"
device = root.find("Descriptions/Devices/Device")
assert device.findtext("Name") == "JausCat robot arm"
objects = {o.findtext("Index"): o for o in device.iter("Object")}
standard = ["#x1000", "#x1001", "#x1008", "#x1009", "#x100A", "#x1018", "#x1600", "#x1A00", "#x1C00", "#x1C12", "#x1C13", "#x1C32", "#x1C33"]
assert list(objects) == standard + ["#x6000", "#x7000", "#x1B15", "#x1BF3"], list(objects)
assert [(m.text, m.get("StartAddress"), m.get("DefaultSize")) for m in device.findall("Sm")] == [
    ("MBoxOut", "#x1000", "128"), ("MBoxIn", "#x1600", "128"), ("Outputs", "#x1C00", "22"), ("Inputs", "#x2400", "22")]
assert [f.text for f in device.findall("Fmmu")] == ["Outputs", "Inputs"]
for pdo, index, manager, mapped in (("RxPdo", "#x1600", "2", "#x7000"), ("TxPdo", "#x1A00", "3", "#x6000")):
    found = device.find(pdo)
    assert (found.findtext("Index"), found.get("Sm")) == (index, manager)
    entries = found.findall("Entry")
    assert [e.findtext("Index") for e in entries] == [mapped] * 14
    assert sum(int(e.findtext("BitLen")) for e in entries) == 22 * 8
    assert (entries[2].findtext("Name"), entries[2].findtext("DataType")) == ("propulsive_linear_effort_x", "INT")
types = {t.findtext("Name"): t for t in device.iter("DataType")}
items = {i.findtext("SubIdx"): i for i in types["DT1B15"].findall("SubItem")}
assert items["26"].findtext("Name") == "set_wrench_effort"
assert items["26"].findtext("Type") == "OCTET_STRING(28)"
assert types["OCTET_STRING(28)"].findtext("BitSize") == "224"
PY
    fi
    expect 0 --check "$work/arm.xml"
    says "things that configuration tools require are there"
    says "ok       Vendor/Id"
    grep -q MISSING "$work/out" && fail "something is missing in its own file"
    "$tool" >"$work/again.xml" || fail "nothing on standard output"
    cmp "$work/arm.xml" "$work/again.xml" || fail "the file and standard output differ"
}

options() {
    expect 0 --help
    says "Examples:"
    expect 0 --component 38
    says "<Index>#x1B1A</Index>"
    says ">component 38</Name>"
    expect 0 --index-base 0x2000
    says "<Index>#x2021</Index>"
    expect 0 --index-base 0x6900 --component 254
    says "<Index>#x69FE</Index>"
    expect 0 --table self-contained
    says "<Name>OCTET_STRING(32)</Name>"
    expect 0 --mailbox-size 1486
    says 'DefaultSize="1486" StartAddress="#x1000"'
    expect 2 --mailbox-size 23
    expect 0 --fixed-length
    says "<Name>ExactSize</Name>"
}

wrong_arguments() {
    for component in 0 255 300; do
        expect 2 --component $component
        says "--component must be a JAUS component ID, 1 to 254"
    done
    expect 2 --table other
    says "--table must be seed or self-contained"
    expect 2 --index-base 1
    expect 2 --no-such-option
    says "Try 'jauscat-esi --help'"
}

broken_files() {
    expect 1 --check "$work/none.xml"
    says "none.xml: cannot be read: No such file or directory"
    expect 1 --output "$work/no/such/folder.xml"
    says "cannot be written"
    echo "no XML" >"$work/text.xml"
    expect 1 --check "$work/text.xml"
    says "text.xml:2: not well-formed XML"
    expect 0 --output "$work/arm.xml"
    sed 's/ Physics="YY"//' "$work/arm.xml" >"$work/cut.xml"
    expect 1 --check "$work/cut.xml"
    says "MISSING  Descriptions/Devices/Device/@Physics"
    says "line 15: <Device>: has no attribute Physics"
}

$2

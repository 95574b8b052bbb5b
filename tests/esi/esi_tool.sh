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
    says "arm.xml has what the schema demands"
    says "ok       Vendor/Id"
    grep -qE "^  (MISSING|without)" "$work/out" && fail "something is missing in its own file: $(cat "$work/out")"
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

sae_messages() {
    # Core and mobility are segments 0 and 1: an object each. The ID is not in the data, the sequence number is.
    expect 0 --sae --component 33=core,set_wrench_effort --component 34=0x0001 --output "$work/sae.xml"
    expect 0 --check "$work/sae.xml"
    says "sae.xml has what the schema demands"
    cp "$work/sae.xml" "$work/out"
    says "<Index>#x2021</Index>"
    says "<Index>#x2121</Index>"
    says "<Index>#x2022</Index>"
    grep -q "<Index>#x2122</Index>" "$work/out" && fail "component 34 has an object without messages"
    says "<Name>set_wrench_effort</Name>"
    [ "$(grep -c "<Name>query_status</Name>" "$work/out")" -ge 1 ] || fail "the core set is not complete"
    python3 - "$work/sae.xml" <<'PY' || fail "the objects are others"
import sys, xml.etree.ElementTree as tree
types = {t.findtext("Name"): t for t in tree.parse(sys.argv[1]).getroot().iter("DataType")}
def item(index, subindex):
    one = next(i for i in types["DT" + index].findall("SubItem") if i.findtext("SubIdx") == str(subindex))
    return one.findtext("Name"), one.findtext("Type")
assert item("2022", 1) == item("2021", 1) == ("set_authority", "OCTET_STRING(10)")
assert item("2121", 2) == ("set_wrench_effort", "OCTET_STRING(29)"), item("2121", 2)
assert len(types["DT2021"].findall("SubItem")) == 55
PY
    expect 0 --sae --component 33=ugv --index-base 0x6900
    says "<Index>#x6D21</Index>"
    expect 2 --sae
    says "--sae needs the messages of each component: --component 33=MESSAGE,..."
    expect 2 --sae --component 33=core,0x0001
    says "--component 33: set_authority is there twice"
    expect 2 --sae --component 33=core --table seed
    says "--sae has a table of its own"
    expect 2 --sae --component 33=core --index-base 6900
    says "--index-base must be 0x2000 or 0x6900 with --sae"
    expect 2 --component 33=core
    says "--component: there is no message 'core'"
}

messages() {
    # By name, by the standard's name and by code; several components.
    expect 0 --component 56=set_joint_velocities,0x2603,"Report Joint Velocities" --component 34=set_wrench_effort
    says "<Name>set_joint_velocities</Name>"
    says "<Name>query_joint_velocities</Name>"
    says "<Name>report_joint_velocities</Name>"
    says "<Index>#x1B2C</Index>"
    says ">component 56</Name>"
    says "<Index>#x1B16</Index>"
    grep -q "query_wrench_effort" "$work/out" && fail "it has messages that were not named"
    cp "$work/out" "$work/own.xml"
    expect 0 --check "$work/own.xml"
    # The same messages as the default has, in another order.
    local arm=report_travel_speed,report_wrench_effort,report_global_pose,report_heartbeat_pulse,report_component_status
    arm+=,query_travel_speed,query_wrench_effort,query_global_pose,query_component_status,set_travel_speed
    arm+=,set_wrench_effort,clear_emergency,set_emergency,set_component_authority
    for table in seed self-contained; do
        for more in "" "--fixed-length --index-base 0x6900"; do
            expect 0 --component 255=$arm --component 33=$arm --table $table $more
            cp "$work/out" "$work/named.xml"
            expect 0 --table $table $more
            cmp "$work/out" "$work/named.xml" || fail "the named messages differ from the default: $table $more"
        done
    done
    expect 0 --component 33=set_wrench_effort --table self-contained --fixed-length --index-base 0x2000
    says "<Index>#x2021</Index>"
    says "<Name>OCTET_STRING(34)</Name>"
    expect 0 --component 33=report_payload_data_element # without a limit: all that a packet carries
    says "<Name>OCTET_STRING(1540)</Name>"
    expect 2 --component 33=set_wrench_efort
    says "there is no message 'set_wrench_efort'; did you mean set_wrench_effort?"
    expect 2 --component 33=0x9999
    says "there is no message with the code 0x9999"
    expect 2 --component 33=0x04zz
    says "there is no message '0x04zz'"
    expect 2 --component 33=
    says "there is no message ''"
    expect 2 --component 33=set_wrench_effort,0x0405
    says "--component 33: set_wrench_effort is there twice"
    expect 2 --component 33 --component 33=reset
    says "--component 33 is there twice"
    expect 2 --component 256=reset
    says "1 to 254, or with messages also 255 for all components"
}

sii() {
    expect 0 --sii "$work/arm.bin"
    [ ! -s "$work/out" ] || fail "with --sii alone it writes an ESI file"
    expect 0 --output "$work/arm.xml" --sii "$work/both.bin"
    cmp "$work/arm.bin" "$work/both.bin" || fail "the SII depends on --output"
    expect 0 --from "$work/arm.xml" --sii "$work/file.bin"
    cmp "$work/arm.bin" "$work/file.bin" || fail "the SII of the file differs"
    expect 0 --from "$work/arm.xml"
    cmp "$work/arm.xml" "$work/out" || fail "a file that is read and written differs"
    [ "$(od -An -tx1 -j16 -N8 "$work/arm.bin" | tr -d ' ')" = 0000434a21000000 ] || fail "vendor and product differ"
    [ $((($(od -An -tu2 -j124 -N2 "$work/arm.bin") + 1) * 128)) = "$(stat -c %s "$work/arm.bin")" ] || fail "wrong size"
    expect 0 --mailbox-size 1486 --sii "$work/large.bin"
    [ "$(od -An -tu2 -j48 -N8 "$work/large.bin" | tr -s ' ')" = " 4096 1486 5632 1486" ] || fail "wrong mailbox"
    expect 2 --from "$work/arm.xml" --component 34
    says "--from and --component exclude each other"
    expect 1 --from "$work/none.xml" --sii "$work/none.bin"
    says "none.xml: cannot be read: No such file or directory"
    expect 1 --sii "$work/no/such/folder.bin"
    says "cannot be written"
    sed 's/Physics="YY"/Physics="KK"/' "$work/arm.xml" >"$work/other.xml"
    expect 0 --from "$work/other.xml" --sii "$work/other.bin"
    [ "$(od -An -tx1 -j16 -N8 "$work/other.bin" | tr -d ' ')" = 0000434a21000000 ] || fail "vendor and product differ"
    sed 's/StartAddress="#x1C00"/StartAddress="#x3C00"/' "$work/arm.xml" >"$work/other.xml"
    expect 1 --from "$work/other.xml" --sii "$work/other.bin"
    says "SyncManager 2 is outside of the memory, 1000h to 2FFFh"
}

several_devices() {
    expect 0 --output "$work/arm.xml"
    # Two more devices: other products, a revision, a module, and a slip in the dictionary of the last.
    python3 - "$work/arm.xml" "$work/more.xml" <<'PY' || fail "cannot make the file"
import sys
text = open(sys.argv[1]).read()
begin, end = text.index("<Device "), text.index("</Devices>")
device = text[begin:end].replace("#x00000021", "#x00000022")
newer = device.replace('RevisionNo="#x00000001"', 'RevisionNo="#x00000005"').replace("<Index>#x1018<", "<Index>#x10Z8<")
newer = newer.replace("</Mailbox>", "</Mailbox><Slots><Slot MaxInstances=\"4\"><Name>bay</Name><ModuleIdent>#x10</ModuleIdent></Slot></Slots>")
newer = newer.replace("</CoE>", "").replace("<CoE ", "<CoE ", 1)
module = '<Modules><Module><Type ModuleIdent="#x10">DI8</Type><Name>eight inputs</Name></Module></Modules>'
open(sys.argv[2], "w").write(text[:end] + device + newer + "</Devices>" + module + text[end + len("</Devices>"):])
PY
    expect 0 --list "$work/more.xml"
    says "device  product     revision    type       name"
    says "2       0x00000022  0x00000005  robot_arm  JausCat robot arm"
    says "module  0x00000010"
    says "more.xml: 3 devices, 1 module"
    expect 0 --list "$work/more.xml" --product 0x22 --revision 9
    says "product 0x00000022, revision 0x00000005"
    says "SyncManager 2: Outputs, start 0x1C00, 22 bytes, control 0x64"
    says "outputs 0x1600 \"Outputs\", SyncManager 2, fixed, mandatory"
    says "  16 bits   0x7000:3  INT       propulsive_linear_effort_x"
    says 'slot "bay", 0 to 4: 0x00000010'
    says '<Index>: "#x10Z8", expected a number'
    expect 1 --list "$work/more.xml" --product 0x23
    says "no <Device> is product #x00000023"
    expect 1 --from "$work/more.xml"
    says "a second device where none is chosen, expected one; there are numbers 0 (robot_arm"
    expect 0 --from "$work/more.xml" --device 0
    cmp "$work/arm.xml" "$work/out" || fail "the first device differs"
    expect 2 --list "$work/more.xml" --product arm
    says "--product must be a number such as 26 or 0x1A, not 'arm'"
    expect 2 --product 1
    says "--product, --revision and --device choose a device of the file of --from or --list"
}

on_a_bus() {
    local folder port bus
    folder=$(dirname "$tool")
    expect 0 --component 56=set_joint_velocities,report_joint_velocities --mailbox-size 200 --output "$work/joints.xml"
    for port in $((20000 + $$ % 20000)) $((20001 + $$ % 20000)) $((20002 + $$ % 20000)); do # one of them is free
        "$folder/emulated_bus" --esi "$work/joints.xml" --slaves 2 --ethercat-port "$port" >"$work/bus" 2>&1 &
        bus=$!
        until grep -q "waiting for a master" "$work/bus" || ! kill -0 $bus; do sleep 0.05; done 2>"$work/gone"
        ! grep -q "waiting for a master" "$work/bus" || break
    done
    "$folder/cyclic" --ethercat-port "$port" --watchdog 2000 --seconds 1 --upload-every 100 >"$work/out" 2>"$work/err" ||
        fail "the master found another slave: $(cat "$work/out" "$work/err" "$work/bus")"
    kill $bus && wait $bus || fail "the bus did not end well: $(cat "$work/bus")"
    says "with another working counter 0"
    says "failed 0"
    grep -q "slave 1: state op" "$work/bus" || fail "it was not in OP: $(cat "$work/bus")"
    tool=$folder/emulated_bus
    expect 1 --esi "$work/none.xml"
    says "none.xml: cannot be read: No such file or directory"
    expect 2 --esi "$work/joints.xml" --outputs 8
    says "--esi and --outputs exclude each other"
    sed 's/>MBoxIn</>Inputs</' "$work/joints.xml" >"$work/drive.xml"
    expect 1 --esi "$work/drive.xml"
    says "expected MBoxOut first, then MBoxIn, and no other"
    expect 1 --esi "$work/joints.xml" --product 0x99
    says "no <Device> is product #x00000099"
    expect 1 --esi "$work/joints.xml" --device 1
    says "no <Device> is number 1"
    expect 2 --device 1
    says "--device and --revision choose a device of --esi"
}

wrong_arguments() {
    for component in 0 255 300 x 33x =reset; do
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

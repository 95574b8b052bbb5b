#!/usr/bin/env bash
# Runs one case on the small examples that need a network: network.sh BIN_FOLDER CASE, in tests/support/in_veth.sh.
set -uo pipefail
bin=$1
work=$(mktemp -d)
cleanup() {
    [ -z "${arm:-}" ] || { kill "$arm" && wait "$arm"; } 2>/dev/null
    [ -z "${server:-}" ] || { kill "$server" && wait "$server"; } 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT

fail() {
    echo "FAILED: $*"
    for file in "$work"/*.log; do echo "--- ${file##*/}" && cat "$file"; done
    exit 1
}
start() { # TEXT COMMAND...: in the background, until it has said the text
    "${@:2}" >"$work/server.log" 2>&1 &
    server=$!
    for _ in $(seq 600); do
        grep -qF -- "$1" "$work/server.log" && return
        sleep 0.05
    done
    fail "$2 does not say within 30 seconds: $1"
}
expect() { # CODE TEXT COMMAND...
    timeout 60 "${@:3}" >"$work/out.log" 2>&1
    local got=$?
    [ "$got" -eq "$1" ] || fail "exit code $got, expected $1: ${*:3}"
    grep -qF -- "$2" "$work/out.log" || fail "$3 does not say: $2"
}

objects_are_written() { # INTERFACE
    expect 0 "the slave has 01 02 03 04" "$bin/sdo_download" "$1" 2000 0 01 02 03 04
    grep -qFx "3 slaves" "$work/out.log" || fail "not all slaves are found"
    grep -qFx "2000h = 01 02 03 04" "$work/server.log" || fail "the slave does not say what it has got"
    expect 0 "01 02 03 04" "$bin/sdo_read" "$1" 2000 0
    expect 0 "00 00 43 4a" "$bin/sdo_read" "$1" 1018 1
    expect 1 "no such object in the dictionary (0x06020000)" "$bin/sdo_read" "$1" 2001 0
    expect 1 "length does not match" "$bin/sdo_download" "$1" 2000 0 01
    expect 1 "no such object" "$bin/sdo_download" "$1" 2001 0 01
    expect 1 "download to station address 1: the slave aborted the transfer" "$bin/sdo_download" "$1" 2000 1 01
    grep -qF "no such subindex" "$work/out.log" || fail "the reason is not told"
    expect 1 "can only be read (0x06010002)" "$bin/sdo_download" "$1" 1018 1 01
}
objects_in_udp() {
    start "three slaves" "$bin/emulated_slaves"
    objects_are_written udp
    expect 2 "INTERFACE INDEX" "$bin/sdo_download" udp 2000
    expect 2 "INTERFACE INDEX" "$bin/sdo_download" udp 2000 0 zz
    expect 2 "INTERFACE INDEX" "$bin/sdo_download" udp 12000 0 01
    expect 2 "INTERFACE INDEX" "$bin/sdo_download" udp 2000 0 1x
    expect 2 "INTERFACE INDEX" "$bin/sdo_read" udp 2000
    expect 2 "INTERFACE INDEX" "$bin/sdo_read" udp 2000 100
    expect 1 "there is no interface" "$bin/sdo_read" no_such_link 2000 0
    expect 1 "there is no interface" "$bin/sdo_download" no_such_link 2000 0 01
    expect 1 "there is no interface" "$bin/emulated_slaves" no_such_link
    expect 2 "INTERFACE" "$bin/emulated_slaves" --help
}
objects_on_a_wire() {
    start "three slaves" "$bin/emulated_slaves" jc1
    objects_are_written jc0
}
a_wrong_size_is_noticed() {
    start "one slave" "$bin/wrong_size_slave"
    expect 1 "do not use the data" "$bin/sdo_read" udp 2000 0
    grep -qFx "the slave's SDO information says 8 bytes" "$work/out.log" || fail "the described size is not told"
    expect 0 "00 00 00 00" "$bin/sdo_read" udp 2001 0
    expect 0 "4a" "$bin/sdo_read" udp 1008 0 # a string may be shorter
}
is_a_component() { # SAYS PROGRAM ARGUMENTS...: the program is system b
    local ocu=("$bin/ocu" --config "$bin/JausConfig.xml" --this a --to 2.1.33.1)
    start "$1" "${@:2}"
    expect 0 "OK: the report equals the command" "${ocu[@]}" --wait 30 propulsive_linear_effort_x=50
    expect 0 "Report Wrench Effort" "${ocu[@]}" --query
}
a_component_answers() { # primitive_driver
    local config=(--config "$bin/JausConfig.xml")
    is_a_component "" "$bin/primitive_driver" "${config[@]}" --this b
    expect 0 "Example" "$bin/primitive_driver" --help
    expect 2 "unknown option 'JausConfig.xml'" "$bin/primitive_driver" JausConfig.xml
    expect 2 "--this needs a value" "$bin/primitive_driver" --this
    expect 1 "primitive_driver: " "$bin/primitive_driver" "${config[@]}" --this nobody
    expect 1 "missing.xml" "$bin/primitive_driver" --config missing.xml
}
a_coroutine_drives() { # drive
    local config=(--config "$bin/JausConfig.xml")
    start "Ctrl-C ends" "$bin/primitive_driver" "${config[@]}" --this b
    expect 0 "in force: 50.0015 %" "$bin/drive" "${config[@]}" --this a
    [ "$(grep -c "reported: 50.0015 %" "$work/out.log")" -eq 3 ] || fail "not three reports"
    expect 0 "standby" "$bin/emergency" "${config[@]}" --this a
    [ "$(tail -n 1 "$work/out.log")" = ready ] || fail "the driver is not Ready after its emergency"
    kill "$server" && wait "$server"
    expect 1 "no answer in time" "$bin/drive" "${config[@]}" --this a
    # A peer that never acknowledges is driven by its reports.
    start "silent peer: ready" python3 "$(dirname "$0")/../nodes/silent_peer.py" 39778 39777 obeys 1
    expect 0 "no answer in time: the reports show" "$bin/drive" "${config[@]}" --this a
    grep -qFx "in force: 50.0015 %" "$work/out.log" || fail "its report is not shown"
    [ "$(grep -c "reported: 50.0015 %" "$work/out.log")" -eq 3 ] || fail "not three reports of the peer"
    kill "$server"
    wait "$server" || true
    # One that never reports: the report that was awaited is named.
    start "silent peer: ready" python3 "$(dirname "$0")/../nodes/silent_peer.py" 39778 39777 mute 1
    expect 1 "Report Wrench Effort: no answer in time" "$bin/drive" "${config[@]}" --this a
}
a_bridge_carries() { # bridge
    local config=(--config "$bin/JausConfig.xml") ocu=("$bin/ocu" --config "$bin/JausConfig.xml" --this a --to 2.1.33.1)
    "$bin/robot_arm" "${config[@]}" --this b >"$work/arm.log" 2>&1 &
    arm=$!
    start "Ctrl-C ends" "$bin/bridge" "${config[@]}" --this b
    expect 0 "OK: the report equals the command" "${ocu[@]}" --wait 30 propulsive_linear_effort_x=50
    expect 0 "Report Wrench Effort" "${ocu[@]}" --query
    kill "$server" && wait "$server"
    expect 0 "vendor" "$bin/objects" udp:127.0.0.1
    grep -q "1b15h" "$work/out.log" || fail "the object of the Primitive Driver is not listed"
    kill "$arm" && wait "$arm"
    expect 1 "no frame returns" "$bin/objects" udp:127.0.0.1
    expect 2 "objects INTERFACE" "$bin/objects"
    expect 1 "nix0" "$bin/objects" nix0
    expect 2 "two_axes INTERFACE" "$bin/two_axes"
    expect 0 "two_axes (JausCat)" "$bin/two_axes" --version
    expect 1 "nix0" "$bin/two_axes" nix0
    expect 2 "two_drives INTERFACE" "$bin/two_drives"
    expect 1 "nix0" "$bin/two_drives" nix0
}
two_drives_are_axes() { # two_axes
    "$bin/emulated_drives" >"$work/arm.log" 2>&1 &
    arm=$!
    until grep -q "six drives" "$work/arm.log"; do sleep 0.05; done # else the first line says that no slave receives
    start ", -0." "$bin/two_axes" udp:127.0.0.1 # there and back; the second axis comes a cycle later
    head -n 1 "$work/server.log" | grep -qE '^(1|0\.99|1\.00)[0-9]*, 0\.(5|49|48)[0-9]*$' || fail "an axis is not there"
    kill -INT "$server" && wait "$server" || fail "two_axes ends with $?"
}
six_drives_are_an_arm() { # six_joints
    local config=(--config "$bin/JausConfig.xml")
    "$bin/emulated_drives" >"$work/arm.log" 2>&1 &
    arm=$!
    start "slave 5 answers, in OP" "$bin/six_joints" "${config[@]}" --this b
    expect 0 "rad" "$bin/move_joints" "${config[@]}" --this a
    tail -n 1 "$work/out.log" | grep -qE '^joints at (0.5|0.49|0.48) -(0.5|0.49|0.48) ' || fail "the joints are not there"
    kill "$arm" && wait "$arm"
    for _ in $(seq 600); do
        grep -q "slave 5 is lost" "$work/server.log" && break
        sleep 0.05
    done
    grep -q "slave 5 is lost" "$work/server.log" || fail "a lost drive is not told of"
    expect 1 "refused by the receiver (NAK)" "$bin/move_joints" "${config[@]}" --this a # the component is in Failure
    expect 2 "emulated_drives [udp:HOST[:PORT]|INTERFACE]" "$bin/emulated_drives" --help
    expect 1 "nix0" "$bin/emulated_drives" nix0
    expect 1 "the port is not 1 to 65535" "$bin/emulated_drives" udp:127.0.0.1:abc
    expect 0 "emulated_drives (JausCat)" "$bin/emulated_drives" --version
}
a_component_of_parts_answers() { # jaus_node
    is_a_component "" "$bin/jaus_node" "$bin/JausConfig.xml" b
    expect 2 "jaus_node CONFIGURATION SYSTEM" "$bin/jaus_node"
    expect 1 "jaus_node: " "$bin/jaus_node" "$bin/JausConfig.xml" nobody
}
absent_peers_are_told_of_once() {
    expect 0 "communicator: stopped" "$bin/communicator" --config "$bin/JausConfig.xml" --this a < <(printf 'wait 4\nq\n')
    [ "$(grep -c "closed port" "$work/out.log")" -eq 2 ] || fail "b and c are told of more than once, or not at all"
}

"$2"

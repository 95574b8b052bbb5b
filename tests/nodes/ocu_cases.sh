# The operator control unit's session: control, refusals, losses, heartbeats; and the demonstration. Sourced by nodes.sh.
# shellcheck shell=bash disable=SC2154,SC2034

second_unit() { # system c, subsystem 3, in the configuration
    local port
    port=$(free_port)
    sed -i "s|^</jausconfig>|<system><name>c</name><jausip>3.0.0.0</jausip><ip>127.0.0.1</ip><port>$port</port></system>\n&|" "$config"
}
expect_c() { expect "$1" "${wrapper[@]}" "$bin/ocu" --config "$config" --this c "${@:2}"; }
unit_ends() { # CODE
    wait "$unit_pid"
    local got=$?
    forget "$unit_pid"
    [ "$got" -eq "$1" ] || fail "the unit ended with exit code $got, expected $1"
}
nobody_controls() {
    expect_ocu 0 --send query_component_control
    says out "subsystem_id = 0"
}

ocu_finds_nobody() {
    expect_ocu 1 --timeout 100 propulsive_linear_effort_x=1
    says out "2.2.33.1 does not answer requests for control; is robot_controller running?"
    says_not out "sends Set Wrench Effort"
    expect_ocu 1 --timeout 100 --query
    says out "no answer to Query Wrench Effort; is robot_controller running?"
    says out "Query Wrench Effort was sent 4 times"
    expect_ocu 1 --wait 0.5 --query
    says out "no heartbeat of a component of subsystem 2 within 0.5 s"
    says_not out "sends Query Wrench Effort"
    # The node is there, the component is not.
    start_robot
    expect_ocu 1 --wait 10 --timeout 100 --to 2.2.34.1 propulsive_linear_effort_x=1
    says out "hears the robot: heartbeat of 2.2.1.1"
    says out "2.2.34.1 does not answer requests for control; its node 2.2.1.1 is there, so look at the JAUS ID"
    says out "heartbeat of 2.2.1.1"
    expect_ocu 0 --wait 10 --query
}
ocu_takes_control_and_releases_it() {
    start_robot
    # One after the other: the second must not be taken for a repeat of the first.
    for _ in 1 2 3; do
        expect_ocu 0 --authority 7 propulsive_linear_effort_x=50
        says out "sends Request Component Control"
        says out "authority_code = 7"
        says out "controls 2.2.33.1"
        says out "the report equals the command"
        says out "control of 2.2.33.1 is released"
    done
    nobody_controls
    # Where nobody has control, no one must ask for it.
    expect_ocu 0 --no-control propulsive_linear_effort_x=20
    says_not out "Component Control"
    expect_ocu 0 --hold 2.5 propulsive_linear_effort_x=30
    says out "keeps control for 2.5 s"
    grep -Eq "ocu: heard [2-9] heartbeats of 2.2.1.1" "$work/out.log" || fail "no heartbeats are counted"
    for state in standby resume; do expect_ocu 0 --send "$state"; done
    says out "ocu: OK"
}
ocu_asks_for_no_acknowledgement() {
    start_robot
    expect_ocu 0 --unacknowledged propulsive_linear_effort_x=50
    says out "OK: obeyed, not acknowledged: the report equals the command"
    says_not out "(ACK)"
    nobody_controls
    expect_ocu 0 --unacknowledged --send standby
    says out "OK: sent, and no acknowledgement was asked for"
    wait_for controller "ready -> standby"
    expect_ocu 1 --unacknowledged --timeout 50 --to 2.2.34.1 --query
    says out "FAILED: no answer to Query Wrench Effort"
}
ocu_commands_a_peer_that_never_acknowledges() {
    local manner code verdict
    while read -r manner code verdict; do
        python3 "$(dirname "${BASH_SOURCE[0]}")/silent_peer.py" "$controller_port" "$ocu_port" "$manner" >"$work/peer.log" 2>&1 &
        pids+=($!)
        last_pid=$!
        wait_for peer "silent peer: ready"
        # Its heartbeats come from the component itself.
        expect_ocu "$code" --wait 30 --timeout 50 propulsive_linear_effort_x=50
        says out "hears the robot: heartbeat of 2.2.33.1"
        says out "controls 2.2.33.1"
        says out "Set Wrench Effort is not acknowledged; the report shows whether it is obeyed"
        says out "$verdict"
        says_not out "nobody acknowledged"
        says out "control of 2.2.33.1 is released, as far as is known"
        dies "$last_pid"
    done <<'EOT'
obeys 0 OK: obeyed, not acknowledged: the report equals the command
ignores 1 FAILED: not acknowledged, not obeyed: the report differs from the command
mute 1 FAILED: no answer to Query Wrench Effort; 2.2.33.1 is heard, but does not answer
EOT
}
ocu_is_not_flooded() { # with reports, none of which it asked for
    second_unit
    start_robot
    hold a propulsive_linear_effort_x=50
    local c_port
    c_port=$(sed -n 's|.*<name>c</name>.*<port>\([0-9]*\)</port>.*|\1|p' "$config")
    for _ in 1 2; do # the next of a kind says how many were left out
        python3 - "$c_port" "$ocu_port" <<'EOT'
import socket, sys
peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
peer.bind(("127.0.0.1", int(sys.argv[1])))
for _ in range(2000):  # Report Wrench Effort, from 3.1.32.1
    peer.sendto(bytes.fromhex("0602054401200101012001030400000001000040"), ("127.0.0.1", int(sys.argv[2])))
EOT
        sleep 1
    done
    wait_for a " such were left out)"
    [ "$(grep -c "^ocu receives Report Wrench Effort" "$work/a.log")" -lt 500 ] || fail "the flood is shown"
    kill -INT "$unit_pid"
    unit_ends 0
    says a "control of 2.2.33.1 is released"
}
ocu_is_refused() {
    second_unit
    start_robot
    hold a --authority 100 propulsive_linear_effort_x=50
    for authority in 0 99 100; do # equal is not higher
        expect_c 1 --authority "$authority" propulsive_linear_effort_x=-20
        says out "FAILED: control of 2.2.33.1 is refused: another has it"
        says out "2.2.33.1 is controlled by 1.1.32.1, authority 100"
        says_not out "sends Set Wrench Effort"
    done
    expect_c 1 --no-control propulsive_linear_effort_x=-20
    says out "Set Wrench Effort was refused (NAK)"
    says out "2.2.33.1 is controlled by 1.1.32.1, authority 100"
    expect_c 1 --no-control --send standby
    # What asks or reports is anybody's.
    expect_c 0 --query
    says out "propulsive_linear_effort_x = 50.001526 % (raw 16384)"
    grep -Eq "propulsive_linear_effort_x .* raw -" "$work/arm.log" && fail "the arm has moved"
    kill -INT "$unit_pid"
    unit_ends 0
    expect_c 0 --authority 0 propulsive_linear_effort_x=-20
}
ocu_loses_control() {
    second_unit
    start_robot
    hold a propulsive_linear_effort_x=50
    expect_c 0 --authority 129 propulsive_linear_effort_x=-20
    unit_ends 0 # its command was done
    says a "receives Reject Component Control"
    says a "LOST control of 2.2.33.1: it was taken away"
    says_not a "Release Component Control"
    nobody_controls
    # A robot that is gone.
    hold a propulsive_linear_effort_x=50
    wait_for a "hears the robot: heartbeat of 2.2.1.1"
    dies "$controller_pid"
    unit_ends 0
    says a "the robot is silent: no heartbeat of 2.2.1.1"
    says a "LOST control of 2.2.33.1: the robot is gone"
}
ocu_loses_control_with_work_left() { # while the arm does not answer its command
    second_unit
    master_options=(--frame-timeout 500 --stop-within 2000)
    start_robot
    kill -STOP "$arm_pid"
    "${wrapper[@]}" "$bin/ocu" --config "$config" --this a --timeout 10000 propulsive_linear_effort_x=50 >"$work/a.log" 2>&1 &
    local unit_a=$!
    pids+=("$unit_a")
    wait_for a "sends Set Wrench Effort"
    kill -STOP "$controller_pid" # it goes on when the request of c is there
    "${wrapper[@]}" "$bin/ocu" --config "$config" --this c --timeout 10000 --authority 200 propulsive_linear_effort_x=-20 >"$work/c.log" 2>&1 &
    local unit_c=$!
    pids+=("$unit_c")
    wait_for c "sends Request Component Control"
    kill -CONT "$controller_pid"
    unit_pid=$unit_a
    unit_ends 1
    says a "LOST control of 2.2.33.1: it was taken away"
    says_not a "is released"
    unit_pid=$unit_c
    unit_ends 1 # the arm does not answer this one either
    says c "controls 2.2.33.1"
    wait_for controller "slave 2 does not answer"
    kill -CONT "$arm_pid"
    wait_for controller "2.2.33.1: initialize -> ready" 2
    expect_c 0 propulsive_linear_effort_x=-20
}
expect_ocu_busy() { # two units cannot be the same system at a time
    expect_ocu 1 --query
    says out "$ocu_port"
}
ocu_stops_an_arm_that_another_controls() {
    second_unit
    start_robot
    hold a propulsive_linear_effort_x=50
    local unit_a=$unit_pid
    expect_ocu_busy
    hold c --send set_emergency emergency_code=transition_to_emergency # as long as it is there, the emergency is its
    local unit_c=$unit_pid
    says arm "EMERGENCY: all efforts to zero"
    says controller "2.2.33.1 is controlled by 1.1.32.1"
    kill -INT "$unit_a"
    unit_pid=$unit_a
    unit_ends 0
    says a "control of 2.2.33.1 is released"
    expect_ocu 1 propulsive_linear_effort_x=1
    says out "2.2.33.1 is in the state emergency"
    expect_ocu 1 --send clear_emergency emergency_code=clear_emergency
    says out "Clear Emergency was refused (NAK)"
    kill -INT "$unit_c"
    unit_pid=$unit_c
    unit_ends 0
    expect_c 0 --send clear_emergency emergency_code=clear_emergency
    expect_ocu 1 propulsive_linear_effort_x=1
    says out "2.2.33.1 is in the state standby"
    expect_ocu 0 --send resume
    expect_ocu 0 propulsive_linear_effort_x=1
}
ocu_releases_on_ctrl_c() {
    start_robot
    for signal in INT TERM; do
        hold a propulsive_linear_effort_x=50
        kill "-$signal" "$unit_pid"
        unit_ends 0
        says a "control of 2.2.33.1 is released"
        nobody_controls
    done
    # Before anything is done it is a failure.
    kill -STOP "$controller_pid"
    "${wrapper[@]}" "$bin/ocu" --config "$config" --this a --timeout 20000 propulsive_linear_effort_x=1 >"$work/a.log" 2>&1 &
    unit_pid=$!
    pids+=("$unit_pid")
    wait_for a "sends Request Component Control"
    kill -INT "$unit_pid"
    kill -CONT "$controller_pid"
    unit_ends 1
    nobody_controls
}
ocu_wrong_arguments() {
    for wrong in "--authority 256" "--authority -1" "--authority x" "--hold -1" "--hold nan" "--wait x" "--timeout 0" \
        "--to 2.255.33.1" "--to 2.0.33.1" "--random 1" "--send nonsense" "--send standby x=1"; do
        [[ $wrong == *--send* ]] || wrong+=" --query"
        # shellcheck disable=SC2086
        expect 2 "$bin/ocu" --config "$config" $wrong
        says out "Try 'ocu --help'"
    done
}
the_demonstration() {
    # Another one may run in another terminal: the ports of the example configuration are taken.
    local examples
    examples=$(dirname "${BASH_SOURCE[0]}")/../../examples
    "$bin/robot_arm" --config "$examples/JausConfig.xml" --this b >"$work/other_arm.log" 2>&1 &
    pids+=($!)
    "$bin/robot_controller" --config "$examples/JausConfig.xml" --this b >"$work/other_controller.log" 2>&1 &
    pids+=($!)
    wait_for_either other_arm "waiting for a master" "Address already in use"
    wait_for_either other_controller "controller: ready" "Address already in use"
    for table in seed self-contained; do
        expect 0 "$(dirname "${BASH_SOURCE[0]}")/../../scripts/demo" --bin "$bin" --table "$table"
        says out "demo: OK: each step ended as expected"
        [ "$(grep -c "demo: the arm holds what was commanded, on each of 12 axes" "$work/out.log")" -eq 9 ] || fail "the arm was not looked at in each step"
    done
    expect 2 "$(dirname "${BASH_SOURCE[0]}")/../../scripts/demo" --nonsense
}

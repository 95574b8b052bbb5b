#!/usr/bin/env bash
# Runs one case on the example nodes: nodes.sh BIN_FOLDER CASE. Exit code 77: skipped, with the reason printed.
# NODE_WRAPPER is a command that every node is run by, such as valgrind: then each must also end well.
set -uo pipefail
bin=$1
work=$(mktemp -d)
namespaces=()
pids=()

cleanup() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
    wait 2>/dev/null
    for ns in "${namespaces[@]}"; do ip netns del "$ns" 2>/dev/null; done
    rm -rf "$work"
}
trap cleanup EXIT

fail() {
    echo "FAILED: $*"
    for file in "$work"/*.log; do [ -f "$file" ] && { echo "--- ${file##*/}"; cat "$file"; }; done
    exit 1
}
# Root can do all of it on a machine that permits namespaces; then a skip would hide a fault.
skip() {
    [ "$(id -u)" -eq 0 ] && [ "${CI:-}" = true ] && fail "skipped as root: $*"
    echo "SKIPPED: $*"
    exit 77
}
says() { grep -qF -- "$2" "$work/$1.log" || fail "$1 does not say: $2"; }
says_not() { ! grep -qF -- "$2" "$work/$1.log" || fail "$1 says: $2"; }
wait_for() { # NAME TEXT [TIMES]: until the node has said it, so many times
    for _ in $(seq 600); do
        [ "$(grep -cF -- "$2" "$work/$1.log" 2>/dev/null)" -ge "${3:-1}" ] 2>/dev/null && return
        sleep 0.05
    done
    fail "$1 does not say within 30 seconds: $2"
}
wait_for_either() { # NAME TEXT TEXT
    for _ in $(seq 600); do
        grep -qF -e "$2" -e "$3" "$work/$1.log" 2>/dev/null && return
        sleep 0.05
    done
    fail "$1 says neither within 30 seconds: $2, $3"
}
expect() { # CODE COMMAND...: its output goes to out.log
    local code=$1
    shift
    timeout 60 "$@" >"$work/out.log" 2>&1
    local got=$?
    [ "$got" -eq "$code" ] || fail "exit code $got, expected $code: $*"
}
forget() { # PID: it has ended
    local pid left=()
    for pid in "${pids[@]}"; do [ "$pid" = "$1" ] || left+=("$pid"); done
    pids=("${left[@]}")
}
dies() { # PID: as in a crash, without a word
    kill -KILL "$1"
    wait "$1" 2>/dev/null
    forget "$1"
}
free_port() { # a UDP port that nobody listens on
    while :; do
        local port=$((20000 + RANDOM % 12000))
        grep -qi "$(printf ':%04X ' "$port")" /proc/net/udp || { echo "$port"; return; }
    done
}

ocu_port=$(free_port)
controller_port=$(free_port)
slave_port=$(free_port)
config=$work/JausConfig.xml
cat >"$config" <<EOF
<jausconfig>
  <thissystem>a</thissystem>
  <system><name>a</name><jausip>1.0.0.0</jausip><ip>127.0.0.1</ip><port>$ocu_port</port></system>
  <system><name>b</name><jausip>2.0.0.0</jausip><ip>127.0.0.1</ip><port>$controller_port</port></system>
</jausconfig>
EOF

prefix=() # put in front of every node: a network namespace
read -ra wrapper <<<"${NODE_WRAPPER:-}"
link=(--ethercat-port "$slave_port")
master_link=()
master_options=(--stop-within 2000) # a busy machine may hold processes up
cycle=10000
[ ${#wrapper[@]} -eq 0 ] || { master_options=(--frame-timeout 1000 --stop-within 6500) cycle=30000; } # what wraps the nodes may slow them down
cyclic=(--cycle "$cycle")
table=seed
node() { # NAME LOG ARGUMENTS...
    local log=$2
    "${prefix[@]}" "${wrapper[@]}" "$bin/$1" --config "$config" --this b --table "$table" "${@:3}" >"$work/$log.log" 2>&1 &
    pids+=($!)
    last_pid=$!
}
arm_options=()
start_arm() {
    local patience=(--command-timeout 20000) # a busy machine may hold the controller up
    case " ${arm_options[*]} " in *" --command-timeout "*) patience=() ;; esac
    node robot_arm arm "${link[@]}" "${patience[@]}" "${arm_options[@]}" && wait_for arm "waiting for a master" && arm_pid=$last_pid
}
start_controller() {
    [ ${#master_link[@]} -gt 0 ] || master_link=("${link[@]}")
    node robot_controller controller "${master_link[@]}" "${master_options[@]}" && wait_for controller "controller: ready" &&
        controller_pid=$last_pid
}
start_robot() { start_arm && start_controller; }
expect_ocu() { expect "$1" "${prefix[@]}" "${wrapper[@]}" "$bin/ocu" --config "$config" --this a "${@:2}"; }
hold() { # SYSTEM ARGUMENTS...: a unit in the background that stays, with control if it needs that; SYSTEM.log has its lines
    "${wrapper[@]}" "$bin/ocu" --config "$config" --this "$1" --hold 60 "${@:2}" >"$work/$1.log" 2>&1 &
    unit_pid=$!
    pids+=("$unit_pid")
    wait_for "$1" " for 60 s; Ctrl-C ends"
}
send_bytes() { # PORT HEX
    printf '%b' "$(sed 's/../\\x&/g' <<<"$2")" >"/dev/udp/127.0.0.1/$1" 2>/dev/null
}

full_command=(propulsive_linear_effort_{x,y,z}=50 propulsive_rotational_effort_{x,y,z}=-50
    resistive_linear_effort_{x,y,z}=50 resistive_rotational_effort_{x,y,z}=100)
the_command_arrives() {
    expect_ocu 0 "${full_command[@]}"
    says out "the report equals the command"
    # 50 % is 16383.5 of 32767 and 127.5 of 255: ties go up.
    says out "propulsive_linear_effort_z = 50.001526 % (raw 16384)"
    says out "resistive_linear_effort_x = 50.196078 % (raw 128)"
    for axis in x y z; do
        grep -Eq "propulsive_linear_effort_$axis .* raw 16384$" "$work/arm.log" || fail "the arm has not moved in $axis"
        grep -Eq "propulsive_rotational_effort_$axis .* raw -16383$" "$work/arm.log" || fail "the arm has not turned in $axis"
        grep -Eq "resistive_rotational_effort_$axis .* raw 255$" "$work/arm.log" || fail "the arm has not braked in $axis"
    done
}

command_and_report_seed() {
    start_robot
    the_command_arrives
    for line in "ulDest = 2" "ulNodeId = 2" "ulIndex = 6933" "ulSubIndex = 26" "ulDataCnt = 28" "ulLen = 44" "n = 28:" \
        "ulSubIndex = 72"; do
        says controller "$line"
    done
    says out "Report Wrench Effort, 36 bytes, 2.2.33.1 -> 1.1.32.1"
}
command_and_report_self_contained() {
    table=self-contained
    start_robot
    the_command_arrives
    for line in "ulDest = 32" "ulIndex = 6933" "ulSubIndex = 26" "ulDataCnt = 32" "ulLen = 48" "n = 32:"; do
        says controller "$line"
    done
}
other_index_bases() {
    link+=(--index-base 0x2000)
    start_robot
    the_command_arrives
    says controller "ulIndex = 8225"
    kill "$controller_pid" "$arm_pid" && wait "$controller_pid" "$arm_pid"
    table=self-contained
    link=(--ethercat-port "$slave_port" --index-base 0x6900) master_link=()
    start_robot
    the_command_arrives
    says controller "ulIndex = 26913"
    expect 2 "$bin/robot_arm" --config "$config" --index-base 0x3000
    says out "--index-base must be 6900, 0x2000 or 0x6900"
}
subindex_0_rule() {
    arm_options=(--subindex-0-rule)
    start_robot
    expect_ocu 1 propulsive_linear_effort_x=1
    says out "was refused (NAK)"
    wait_for controller "write 0 there first (0x06010003)"
    says controller "ulSta 0xC0650044"
    kill "$controller_pid" "$arm_pid" && wait "$controller_pid" "$arm_pid"
    master_options+=(--clear-subindex-0)
    start_robot
    the_command_arrives
    kill "$controller_pid" "$arm_pid" && wait "$controller_pid" "$arm_pid"
    unset 'master_options[-1]'
    link=(--ethercat-port "$slave_port" --index-base 0x2000) master_link=() # not a mapping object
    start_robot
    the_command_arrives
}
private_message() {
    expect 0 "${wrapper[@]}" "$bin/private_message"
    for line in "opening = 80" "ul_index = 8225" "ul_sub_index = 159" "translated back: the same 21 bytes" \
        "slave: object 0x2021:159, 17 bytes" "confirmation: ok (ulSta 0x00000000)" "slave: finger 0, opening 80" \
        "force 20 %" "answer: command code 0xD101 (ACK), 16 bytes, 1.2.33.1 -> 1.1.32.1, sequence 7"; do
        says out "$line"
    done
}
card_packets() {
    expect 0 "${wrapper[@]}" "$bin/card_packets"
    for line in "scan: ok (ulSta 0x00000000)" "slaves: 2" "vendor 0x00001A2B, product 0x00000002" \
        "0x1018:1 is 2b 1a 00 00" '0x1018 "Identity", highest subindex 4' "state 4"; do
        says out "$line"
    done
    expect 1 "${wrapper[@]}" "$bin/card_packets" no_such_link
    says out "card_packets: "
}
colours_are_for_terminals() {
    command -v script >/dev/null || skip "script (package bsdutils) is missing"
    on_terminal() { # VARIABLE=VALUE... PROGRAM ARGUMENTS: as one word for script
        env TERM=xterm NO_COLOR= "${@:1:$#-1}" script -qec "${wrapper[*]} $bin/${!#}" /dev/null >"$work/out.log" 2>&1
    }
    local escape=$'\033'
    on_terminal "cyclic --period 0"
    says out "${escape}[31mcyclic: --period must be 1 to 1000000${escape}[0m"
    on_terminal "ocu --help"
    says out "${escape}[1mOptions${escape}[0m:"
    on_terminal NO_COLOR=1 "ocu --help"
    says out "Options:"
    says_not out "${escape}["
    on_terminal TERM=dumb "ocu --help"
    says_not out "${escape}["
    expect 0 "$bin/ocu" --help
    says out "Options:"
    says_not out "${escape}["
    start_robot
    on_terminal "ocu --config $config --this a propulsive_linear_effort_x=50"
    says out "${escape}[32mOK: the report equals the command${escape}[0m"
    says_not controller "${escape}["
    says_not arm "${escape}["
}
strict_arm() {
    arm_options=(--strict)
    start_robot
    the_command_arrives # with all its fields it has the object's size
    expect_ocu 1 propulsive_linear_effort_x=1
    says out "was refused (NAK)"
    wait_for controller "abort code 0x06070010"
    says controller "needs the translation table's option fixed_length"
    kill "$controller_pid" "$arm_pid" && wait "$controller_pid" "$arm_pid"
    for table in seed self-contained; do
        link=(--ethercat-port "$slave_port" --fixed-length) master_link=()
        start_robot
        the_command_arrives
        expect_ocu 0 propulsive_linear_effort_y=-100
        expect_ocu 0 --query
        says out "propulsive_linear_effort_y = -100 % (raw -32767)"
        kill "$controller_pid" "$arm_pid" && wait "$controller_pid" "$arm_pid"
    done
}
jaus01_prefix_in_front() {
    sed -i 's|</port>|</port><framing>JAUS01.0</framing>|' "$config"
    master_options+=(--open)
    start_robot
    the_command_arrives
    # A bare message is taken all the same.
    send_bytes "$controller_port" 060205040121020201200101040009000100ff3f
    wait_for arm "raw 16383"
}
query_alone() {
    start_robot
    expect_ocu 0 propulsive_linear_effort_y=-100
    expect_ocu 0 --query
    says out "presence_vector = 0x0FFF"
    says out "propulsive_linear_effort_y = -100 % (raw -32767)"
    says out "resistive_rotational_effort_z = 0 % (raw 0)"
}
random_fields() {
    start_robot
    for seed in 1 2 3 4 5; do expect_ocu 0 --random "$seed"; done
}
any_message() {
    start_robot
    expect_ocu 0 --send set_travel_speed desired_speed=2.5 # the nearest of 16 bits over 10000 m/s
    says out "ocu: OK"
    says arm "travel speed 2.4414435 m/s"
    expect_ocu 0 --send query_travel_speed
    expect_ocu 0 --send "Set Component Authority" authority_code=7
    # Each message of the standard has a name; what the robot does not take it refuses itself.
    expect_ocu 1 --send query_camera_pose camera_id=1 presence_vector=1
    says out "camera_id = 1"
    says out "Query Camera Pose was refused (NAK)"
}
wrong_arguments() {
    expect 2 "$bin/ocu"
    expect 2 "$bin/ocu" speed=5
    says out "there is no field 'speed'"
    expect 2 "$bin/ocu" propulsive_linear_effort_x=101
    says out "must be -100 to 100 %"
    expect 2 "$bin/ocu" propulsive_linear_effort_x=
    expect 2 "$bin/ocu" --send set_travel_sped desired_speed=1
    says out "did you mean set_travel_speed?"
    expect 2 "$bin/ocu" --send set_travel_speed
    says out "desired_speed is missing"
    expect 2 "$bin/ocu" --send set_camera_pose
    says out "mode_indicator is missing"
    expect 2 "$bin/ocu" --to 1.2.3 --query
    says out "is no JAUS ID"
    expect 2 "$bin/robot_arm" --link token-ring --config "$config"
    expect 2 "$bin/robot_arm" --link raw --config "$config"
    says out "needs --interface"
    expect 2 "$bin/robot_controller" --table paper --config "$config"
    expect 2 "$bin/robot_controller" --station 0 --config "$config"
    for program in ocu robot_controller robot_arm; do
        expect 2 "$bin/$program" --nonsense
        expect 0 "$bin/$program" --help
        says out "Examples:"
    done
}
missing_config() {
    for program in robot_controller robot_arm "ocu --query"; do
        # shellcheck disable=SC2086
        expect 1 "$bin/"$program --config "$work/none.xml"
        says out "none.xml"
    done
    expect 1 "$bin/ocu" --config "$config" --this c --query
    says out '"c"'
}
malformed_config() {
    printf '<jausconfig>\n<thissystem>a</thissystem>\n<system><name>a</jausconfig>\n' >"$work/bad.xml"
    expect 1 "$bin/ocu" --config "$work/bad.xml" --query
    says out "bad.xml:3"
}
busy_port() {
    start_robot
    expect 1 "$bin/robot_arm" --config "$config" --this b "${link[@]}"
    says out "$slave_port"
    expect 1 "$bin/robot_controller" --config "$config" --this b "${link[@]}"
    says out "$controller_port"
    the_command_arrives
}
no_slave() {
    expect 1 "$bin/robot_controller" --config "$config" --this b "${link[@]}" --wait 300
    says out "no slave to work with"
}
closed_port() {
    expect_ocu 1 --timeout 100 --query
    says out "closed port"
    says out "FAILED"
}
garbage_on_the_sockets() {
    # Closed, as it is by default, the controller takes nothing from a port that is nobody's: Set Wrench Effort.
    start_robot
    send_bytes "$controller_port" 160205040121020201200101040009000100ff3f
    wait_for controller "is refused: wrong sender"
    says_not controller "received Set Wrench Effort"
    kill "$controller_pid" && wait "$controller_pid"
    forget "$controller_pid"
    master_options+=(--open)
    start_controller
    for port in "$controller_port" "$slave_port"; do
        send_bytes "$port" 00
        send_bytes "$port" 4a41555330312e30
        send_bytes "$port" ffffffffffffffffffffffffffffffffffffffffffffffff
        send_bytes "$port" "$(head -c 1400 /dev/urandom | od -An -tx1 | tr -d ' \n')"
        for _ in $(seq 50); do send_bytes "$port" "$(head -c $((1 + RANDOM % 200)) /dev/urandom | od -An -tx1 | tr -d ' \n')"; done
    done
    # A Set Wrench Effort whose presence vector announces more than there is, asking for an acknowledgement.
    send_bytes "$controller_port" 1602050401210202012001010200630000ff0f
    send_bytes "$controller_port" 16020504012102020120010102006300ff0f
    wait_for controller "is refused: malformed"
    wait_for arm "refused the body of Set Wrench Effort"
    wait_for controller "not delivered to 2.2.33.1: value out of range (ulSta 0xC065003B, abort code 0x06090030), asked at station address 2 (0x0002)"
    wait_for controller "sent Set Wrench Effort (NAK)"
    # A command code nobody knows.
    send_bytes "$controller_port" 16029999012102020120010100006300
    wait_for controller "unknown command code"
    the_command_arrives
}
a_flood_does_not_fill_the_log() { # each of these makes 30 lines
    master_options+=(--open)
    start_robot
    exec 9>"/dev/udp/127.0.0.1/$controller_port"
    for _ in $(seq 3000); do printf '\x06\x02\x05\x04\x01\x21\x02\x02\x01\x20\x01\x01\x04\0\x09\0\x01\0\xff\x3f' >&9; done
    exec 9>&-
    for _ in $(seq 100); do # the next entry of a cause says how many were left out
        expect_ocu 0 --query
        grep -q " such were left out)" "$work/controller.log" && break
    done
    says controller " such were left out)"
    [ "$(grep -c "controller: received Set Wrench Effort" "$work/controller.log")" -lt 1000 ] || fail "the flood is shown"
    the_command_arrives
}
unknown_node() {
    start_robot
    expect_ocu 1 --to 2.9.33.1 propulsive_linear_effort_x=1
    wait_for controller "-> 2.9.33.1: unroutable: no way to the destination is known"
    expect_ocu 1 --to 2.2.99.1 propulsive_linear_effort_x=1
    wait_for controller "-> 2.2.99.1: unroutable: this node has no such component"
    says_not arm "1.1.32.1 ->"
}
other_subsystem() {
    start_robot
    expect_ocu 1 --to 3.2.33.1 propulsive_linear_effort_x=1
    says out "3.2.33.1"
}
large_data_set_is_delivered() {
    master_options+=(--open)
    start_robot
    local head=160205040121020201200101 # Set Wrench Effort with one field; each packet asks for an acknowledgement
    send_bytes "$controller_port" "${head}0210000001"   # wrong size: dropped
    send_bytes "$controller_port" "${head}021000000100" # the first packet: presence vector
    sleep 0.2
    says_not controller "ulDataCnt = 12"
    send_bytes "$controller_port" "${head}02800100ff3f" # the last packet: the effort
    wait_for controller "ulDataCnt = 12"
    wait_for arm "raw 16383"
    # More than an SDO packet holds.
    send_bytes "$controller_port" "${head}f4110000$(printf '%01000d' 0)"
    for i in 1 2; do send_bytes "$controller_port" "${head}f4210${i}00$(printf '%01000d' 0)"; done
    send_bytes "$controller_port" "${head}f4810300$(printf '%01000d' 0)"
    wait_for controller "not delivered to 2.2.33.1: more bytes than an SDO carries"
}
small_mailbox() { # of 8 bytes of data in a first message and 15 in a segment
    arm_options=(--mailbox-size 24 --empty-start --node 2)
    start_robot
    the_command_arrives
    says controller "SDO segment request, mailbox length 18"
    expect 2 "$bin/robot_arm" --config "$config" --mailbox-size 23
    says out "--mailbox-size must be 24 to 1486"
    expect 2 "$bin/robot_arm" --config "$config" --node 255
    says out "--node must be a JAUS node, 1 to 254"
}
command_by_process_data() {
    master_options+=("${cyclic[@]}" --open)
    start_robot
    wait_for arm "state op, station address 2"
    the_command_arrives
    says controller "in OP (Ctrl-C ends)"
    says controller "into the process image, command 2: 02 00 ff 0f 00 40 00 40 00 40 01 c0 01 c0 01 c0 80 80 80 ff ff ff"
    says controller "answers from the process image: 02 00 ff 0f 00 40"
    says controller "sent Set Wrench Effort (ACK)"
    says arm "efforts by process data, command 2" # the first one brought it to rest
    says_not controller "translated to an SDO download packet" # nothing has gone by the mailbox yet
    says_not arm "received Set Wrench Effort"
    # Fields that a command leaves out keep their effort; a query gets what it asks for.
    expect_ocu 0 propulsive_linear_effort_y=-100
    says controller "command 3: 03 00 02 00 00 40 01 80"
    expect_ocu 0 --query
    says out "propulsive_linear_effort_x = 50.001526 % (raw 16384)"
    says out "propulsive_linear_effort_y = -100 % (raw -32767)"
    for seed in 1 2 3 4 5; do expect_ocu 0 --random "$seed"; done
    # -32768 stands for no effort.
    send_bytes "$controller_port" 1602050401210202012001010400090001000080
    wait_for controller "not delivered to 2.2.33.1: out of range"
    wait_for controller "sent Set Wrench Effort (NAK)"
}
other_messages_between_cycles() {
    master_options+=("${cyclic[@]}")
    start_robot
    expect_ocu 0 --send set_travel_speed desired_speed=2.5
    says arm "travel speed 2.4414435 m/s"
    says controller "ulDataCnt"
    expect_ocu 0 --send query_travel_speed
    the_command_arrives
    says controller "into the process image"
    # An emergency comes by the mailbox, and process data do not bring the efforts back.
    expect_ocu 0 --send set_emergency emergency_code=transition_to_emergency
    wait_for arm "EMERGENCY: all efforts to zero"
    for _ in 1 2 3 4 5; do # a report is as old as the last cycle
        expect_ocu 0 --query
        grep -qF "propulsive_linear_effort_x = 0 % (raw 0)" "$work/out.log" && break
        sleep 0.1
    done
    says out "propulsive_linear_effort_x = 0 % (raw 0)"
    expect_ocu 1 propulsive_linear_effort_x=1
    wait_for controller "refused: the component is not ready"
    says_not arm "command 4" # the first brought it to rest, the second moved it, the third is zero again
}
arm_restarts_between_cycles() {
    master_options+=("${cyclic[@]}")
    start_robot
    the_command_arrives
    kill "$arm_pid" && wait "$arm_pid" 2>/dev/null
    wait_for controller "slave 2 does not answer"
    expect_ocu 1 --timeout 5000 propulsive_linear_effort_x=1
    says out "was refused (NAK)"
    start_arm
    wait_for arm "state op, station address 2"
    wait_for controller "2.2.33.1: initialize -> ready" 2
    says_not arm "raw 16384" # what stood in the outputs is no new command
    the_command_arrives
}
controller_restarts_between_cycles() {
    master_options+=("${cyclic[@]}")
    start_robot
    the_command_arrives
    kill "$controller_pid" && wait "$controller_pid"
    wait_for arm "no process data any more: all efforts to zero"
    start_controller
    expect_ocu 0 --query
    says out "propulsive_linear_effort_x = 0 % (raw 0)"
    the_command_arrives
}
slave_leaves_op() { # as its watchdog bids, when the controller has been stopped for a while
    master_options+=("${cyclic[@]}")
    start_robot
    the_command_arrives
    kill -STOP "$controller_pid"
    wait_for arm "no process data any more: all efforts to zero"
    kill -CONT "$controller_pid"
    wait_for controller "2.2.33.1: ready -> failure"
    wait_for controller "2.2.33.1: initialize -> ready" 2
    the_command_arrives
}
arm_rests_without_messages() {
    arm_options=(--command-timeout 300)
    start_robot
    the_command_arrives
    dies "$controller_pid"
    wait_for arm "no message for 300 ms: all efforts to zero"
    arm_options=(--command-timeout 0 --ethercat-port "$(free_port)")
    node robot_arm arm2 "${arm_options[@]}" && wait_for arm2 "without --command-timeout, efforts stay when the master falls silent"
}
cycles_are_measured() {
    start_arm
    expect 0 "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" --watchdog 2000 --seconds 2 --upload-every 100
    says out "22 bytes of outputs, 22 of inputs"
    says out "wake-up after the instant it was due"
    says out "round trip of the process data"
    says out "with another working counter 0"
    grep -Eq "^uploads meanwhile ([5-9]|1[0-9]|2[01]), failed 0$" "$work/out.log" || fail "uploads do not get through"
    says arm "state op, station address 1"
    says arm "state pre_op, station address 1"
    expect 2 "$bin/cyclic" --period 0
    expect 2 "$bin/cyclic" --watchdog 6554
    says out "--watchdog must be 1 to 6553"
}
cyclic_sees_a_slave_leave_op() { # because another master takes the slaves
    start_bus "${link[@]}" --slaves 2 --outputs 2 --inputs 2
    "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" --watchdog 2000 --seconds 60 >"$work/first.log" 2>&1 &
    local first=$!
    pids+=("$first")
    wait_for first "2 in OP"
    # The second one gives the slaves other station addresses.
    expect 0 "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" --watchdog 2000 --seconds 1 --station 11
    wait_for first "slave 1 does not run: "
    wait_for first "slave 2 does not run: no slave has its station address"
    kill -INT "$first"
    wait "$first"
    [ $? -eq 1 ] || fail "cyclic ends well although no slave is in OP"
    forget "$first"
}
cyclic_ends_on_ctrl_c() { # also where no slave answers any more
    start_bus "${link[@]}" --slaves 5 --outputs 2 --inputs 2
    "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" --watchdog 2000 --frame-timeout 500 \
        --seconds 60 >"$work/first.log" 2>&1 &
    local first=$!
    pids+=("$first")
    wait_for first "5 in OP"
    kill -STOP "$bus_pid"
    (wait_for first "slave 5 does not run: frames do not come back")
    local seen=$?
    kill -INT "$first"
    timeout 10 tail --pid="$first" -f /dev/null
    local ended=$?
    kill -CONT "$bus_pid" # before anything fails: a stopped program does not end
    [ "$seen" -eq 0 ] || exit 1
    [ "$ended" -eq 0 ] || fail "cyclic does not end within 10 s of Ctrl-C"
    forget "$first"
}
start_bus() { # OPTIONS...
    "${prefix[@]}" "${wrapper[@]}" "$bin/emulated_bus" "$@" >"$work/bus.log" 2>&1 &
    bus_pid=$!
    pids+=("$bus_pid")
    wait_for bus "waiting for a master"
}
a_bus_of_emulated_slaves() {
    start_bus "${link[@]}" --slaves 5 --outputs 10 --inputs 7 --mailbox-size 40 --slow 3
    says bus "5 slaves, EtherCAT in UDP"
    # A master that dies: the watchdog of each slave that had its outputs.
    "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" >/dev/null 2>&1 &
    local master=$!
    wait_for bus "slave 5: state op"
    dies "$master"
    wait_for bus "slave 5: state safe_op, error 0x001B: SyncManager watchdog"
    # The next one brings them up again.
    expect 0 "${wrapper[@]}" "$bin/cyclic" --ethercat-port "$slave_port" --period "$cycle" --watchdog 2000 --seconds 2 --upload-every 100
    says out "slave 5: 10 bytes of outputs, 7 of inputs"
    says out "with another working counter 0"
    says out "failed 0"
    says bus "slave 5: station address 5 (0x0005)"
    says bus "slave 5: state pre_op"
    kill -INT "$bus_pid" && wait "$bus_pid"
    [ $? -eq 0 ] || fail "the bus does not end well on Ctrl-C"
    says bus "stopped after"
    for wrong in "--slaves 0" "--outputs 683" "--inputs 1025" "--mailbox-size 23" "--abort 0x2000" "--abort 0x2000:256=1" \
        "--object x=1"; do
        # shellcheck disable=SC2086
        expect 2 "$bin/emulated_bus" $wrong
        says out "${wrong%% *}"
    done
    expect 0 "$bin/emulated_bus" --help
    says out "Examples:"
}
a_slave_of_another_node_is_told_of() { # which takes its JAUS address from its own configuration
    start_bus "${link[@]}" --abort 0x1B15=0x06040043
    start_controller
    wait_for controller "2.2.33.1: the slave has not confirmed zero efforts, attempt 1: parameters are incompatible (ulSta 0xC0650034, abort code 0x06040043), asked at station address 2 (0x0002): the slave must be JAUS node 2 of subsystem 2, see robot_arm --node"
}
arm_restarts() {
    start_robot
    the_command_arrives
    kill "$arm_pid" && wait "$arm_pid" 2>/dev/null
    expect_ocu 1 --timeout 5000 propulsive_linear_effort_x=1
    says out "was refused (NAK)"
    start_arm
    wait_for controller "slave 2 is in PRE-OP" 2
    the_command_arrives
}
ctrl_c() {
    start_robot
    kill -INT "$controller_pid" && wait "$controller_pid"
    [ $? -eq 0 ] || fail "the controller does not end well on Ctrl-C"
    says controller "controller: stopped"
    kill -TERM "$arm_pid" && wait "$arm_pid"
    [ $? -eq 0 ] || fail "the arm does not end well on SIGTERM"
    says arm "arm: stopped"
}

communicators_talk() {
    [ -x "$bin/communicator" ] || skip "communicator was not built: it needs libedit"
    # The receiving one goes on until it is told to stop; `wait` keeps its input open.
    "${wrapper[@]}" "$bin/communicator" --config "$config" --this b >"$work/b.log" 2>&1 < <(printf 'log on\nwait 600\n') &
    pids+=($!)
    local other=$!
    wait_for b "communicator: 2.1.32.1 of b at 127.0.0.1"
    talk() { # CODE LINES: what the other communicator makes of them
        printf '%b' "$2" >"$work/lines"
        expect "$1" "${wrapper[@]}" "$bin/communicator" --config "$config" --this a <"$work/lines"
    }
    talk 0 'send b set_component_authority authority_code=5\nsend b query_component_authority\nhelp\nq\n'
    says out "Set Component Authority to 2.1.32.1: acknowledged"
    says out "received Report Component Authority"
    says out "authority_code = 5"
    says out "send WHOM MESSAGE"
    wait_for b "received Set Component Authority, 17 bytes, 1.1.32.1 -> 2.1.32.1"
    # Control, and a list; the last line has no end.
    talk 0 'send 2.1.32.1 request_component_control authority_code=9\nsend b standby\nsend b query_component_status\nwait 1\nsend b release_component_control\nsend 2.1.1.1 query_configuration query_field=node_configuration\npeers'
    says out "received Confirm Component Control"
    says out "received Report Component Status"
    says out "primary_status_code = standby"
    says out "received Report Configuration"
    grep -Eq "^  b +2\.0\.0\.0 +127\.0\.0\.1 port $controller_port +framing bare$" "$work/out.log" || fail "b is not among the peers"
    says out "heard: 2.1.1.1"
    wait_for b "controlled by 1.1.32.1"
    wait_for b "state: standby"
    wait_for b "controlled by nobody"
    wait_for b "1.1.1.1 is there"
    # A command that nobody there obeys, lines that are wrong, destinations that lead nowhere.
    talk 1 'send b set_travel_speed desired_speed=2.5\nq\n'
    says out "refused by the receiver (NAK)"
    for wrong in "send c standby" "send b standy" "send b set_component_authority authority_code=x" "nonsense" \
        "send 9.1.32.1 standby" "send 2.1.99.1 query_component_status" "wait x"; do
        talk 1 "$wrong\n"
    done
    talk 1 'send b standy\n'
    says out "did you mean standby?"
    wait_for b "this node has no such component"
    # Who is not in the configuration may not send. Standby from 7.1.32.1.
    send_bytes "$controller_port" 06020300012001020120010700000000
    wait_for b "unknown peer"
    expect 2 "$bin/communicator" --nonsense
    expect 0 "$bin/communicator" --help
    says out "Examples:"
    expect 1 "$bin/communicator" --config "$work/none.xml"
    expect 1 "$bin/communicator" --config "$config" --this b </dev/null
    says out "$controller_port"
    kill -INT "$other" && wait "$other"
    [ $? -eq 0 ] || fail "a communicator does not end well on Ctrl-C"
    says b "communicator: stopped; received"
}

# Two network namespaces joined by a cable: master_ns has if_m, slave_ns has if_s.
two_namespaces() {
    [ "$(id -u)" -eq 0 ] || skip "network namespaces need root"
    command -v ip >/dev/null || skip "ip (package iproute2) is missing"
    master_ns=jc-m-$$ slave_ns=jc-s-$$
    ip netns add "$master_ns" 2>"$work/netns" || skip "no network namespace: $(cat "$work/netns")"
    namespaces+=("$master_ns")
    ip netns add "$slave_ns" && namespaces+=("$slave_ns")
    ip -n "$master_ns" link add if_m type veth peer name if_s netns "$slave_ns" 2>"$work/netns" ||
        skip "no veth pair: $(cat "$work/netns")"
    ip -n "$master_ns" link set lo up
    ip -n "$master_ns" link set if_m up
    ip -n "$slave_ns" link set if_s up
}
start_raw_robot() {
    prefix=(ip netns exec "$slave_ns") link=(--link raw --interface if_s)
    start_arm
    prefix=(ip netns exec "$master_ns") master_link=(--link raw --interface if_m)
    start_controller
}
raw_link_in_a_namespace() {
    two_namespaces
    start_raw_robot
    the_command_arrives
    says controller "raw Ethernet on if_m"
}
card_packets_on_a_wire() {
    two_namespaces
    prefix=(ip netns exec "$slave_ns") link=(--link raw --interface if_s)
    start_arm
    expect 0 ip netns exec "$master_ns" "${wrapper[@]}" "$bin/card_packets" if_m
    says out "slaves: 1"
    says out '0x1B15 "component 33", highest subindex 125'
    says out "state 4"
}

emulated_slaves_on_a_wire() {
    two_namespaces
    prefix=(ip netns exec "$slave_ns")
    start_bus --link raw --interface if_s --slaves 3 --outputs 4 --mailbox-size 24
    expect 0 ip netns exec "$master_ns" "${wrapper[@]}" "$bin/card_packets" if_m
    says out "slaves: 3"
    says out '0x1018 "Identity", highest subindex 4'
    says out '0x2003 "value of 28 bytes", highest subindex 0'
    says out '0x7000 "record", highest subindex 4'
    says bus "slave 1: state safe_op"
}

# What tshark makes of the SDO download of a full Set Wrench Effort; the capture is in $work/wire.pcap.
start_capture() { # INTERFACE FILTER
    command -v tshark >/dev/null || skip "tshark is missing"
    "${prefix[@]}" tshark -q -i "$1" -f "$2" -w "$work/wire.pcap" >"$work/tshark.log" 2>&1 &
    pids+=($!)
    capture_pid=$!
    wait_for tshark "Capturing on"
    sleep 1 # tshark says so shortly before it does
}
stop_capture() {
    sleep 0.5
    kill -INT "$capture_pid" && wait "$capture_pid" 2>/dev/null
}
check_capture() {
    stop_capture
    local downloads
    downloads=$(tshark -r "$work/wire.pcap" -Y 'ecat_mailbox.coe.sdoreq == 1 && ecat.cnt == 1' -T fields -E separator=' ' \
        -e ecat_mailbox.coe.sdoidx -e ecat_mailbox.coe.sdosub -e ecat_mailbox.coe.sdolength -e ecat_mailbox.coe.dsoldata 2>/dev/null)
    # Message properties 16 02 (acknowledgement wanted), source 1.1.32.1, any sequence number, then the body.
    data=160201200101....ff0f00400040004001c001c001c0808080ffffff
    grep -qi "^0x1b15 0x1a 0x0000001c $data\$" <<<"$downloads" || fail "tshark reads: $downloads (expected $data)"
    check_frames
}
check_frames() {
    local bad
    bad=$(tshark -r "$work/wire.pcap" -Y '_ws.malformed || ecat_mailbox.invalid || ecat_mailbox.coe.invalid || _ws.expert.severity == error' 2>/dev/null)
    [ -z "$bad" ] || fail "tshark finds malformed frames: $bad"
    local other
    other=$(tshark -r "$work/wire.pcap" -Y '!ecat' 2>/dev/null)
    [ -z "$other" ] || fail "tshark finds frames that are not EtherCAT: $other"
}
tshark_reads_ethercat_in_udp() {
    two_namespaces
    prefix=(ip netns exec "$master_ns")
    link=() # the registered port, which tshark knows
    start_capture lo "udp port 34980"
    start_robot
    the_command_arrives
    check_capture
}
tshark_reads_raw_frames() {
    two_namespaces
    prefix=(ip netns exec "$master_ns")
    start_capture if_m "ether proto 0x88a4"
    start_raw_robot
    the_command_arrives
    check_capture
    local short
    short=$(tshark -r "$work/wire.pcap" -Y 'frame.len < 60' 2>/dev/null)
    [ -z "$short" ] || fail "frames shorter than 60 bytes: $short"
}
tshark_reads_process_data() {
    two_namespaces
    prefix=(ip netns exec "$master_ns")
    start_capture if_m "ether proto 0x88a4"
    master_options+=("${cyclic[@]}")
    start_raw_robot
    the_command_arrives
    stop_capture
    check_frames
    # LRW: outputs with the command that the controller has shown, then inputs with what the arm has in force.
    local data=0200ff0f00400040004001c001c001c0808080ffffff
    tshark -r "$work/wire.pcap" -Y 'ecat.cmd == 12 && ecat.cnt == 3' -T fields -e ecat.data >"$work/cycles.log" 2>/dev/null
    grep -Eq "^$data$data(,|\$)" "$work/cycles.log" || fail "no cycle with the command and the report"
}

for cases in "$(dirname "$0")"/*_cases.sh; do
    # shellcheck source=tests/nodes/controller_cases.sh
    . "$cases"
done
declare -F "$2" >/dev/null || fail "there is no case '$2'"
"$2"
if [ ${#wrapper[@]} -gt 0 ]; then
    # The last first: a controller whose arm is gone cannot bring it to rest, and says so by its exit code.
    for ((i = ${#pids[@]} - 1; i >= 0; i--)); do
        kill -TERM "${pids[i]}" && wait "${pids[i]}" || fail "a node did not end well under ${wrapper[0]}"
    done
fi
echo "ok: $2"

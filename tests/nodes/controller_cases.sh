# shellcheck shell=bash disable=SC2154 # read by nodes.sh
# Cases of the robot controller: several masters, and what it does to a slave when a component is not to move it.

# The systems b (2.2.0.0), g (2.3.0.0) and h (2.2.34.0), whose masters are on the interfaces given; b drives all.
several_masters_on() { # INTERFACE_B INTERFACE_G INTERFACE_H
    cat >"$config" <<EOF2
<jausconfig thissystem="a">
  <system name="a" jausip="1.0.0.0" ip="127.0.0.1" port="$ocu_port"/>
  <system name="b" jausip="2.2.0.0" ip="127.0.0.1" port="$controller_port"><ethercat interface="$1"/></system>
  <system name="g" jausip="2.3.0.0" ip="127.0.0.1" port="$(free_port)">
    <ethercat controller="b" interface="$2"/>
  </system>
  <system name="h" jausip="2.2.34.0" ip="127.0.0.1" port="$(free_port)">
    <ethercat controller="b" interface="$3"/>
  </system>
</jausconfig>
EOF2
}
start_several_masters() {
    node robot_controller controller "${master_options[@]}"
    controller_pid=$last_pid
    for system in b g h; do wait_for controller "controller $system: ready: JAUS on"; done
}
each_command_reaches_its_slave() {
    expect_ocu 0 --to 2.2.33.1 propulsive_linear_effort_x=50
    says arm "raw 16384"
    says_not arm2 "raw 16384"
    expect_ocu 0 --to 2.3.33.1 propulsive_linear_effort_y=-100
    says arm2 "raw -32767"
    says_not arm "raw -32767"
    # All fields, as long as the object of the emulated slave.
    expect_ocu 0 --to 2.2.34.1 --send set_wrench_effort "${full_command[@]}"
    wait_for bus "0x1B16:26 = 16 02"
    grep -c "received Set Wrench Effort" "$work/arm.log" | grep -qx 2 || fail "the arm has got the command of another" # zeros at first
    says controller "controller h: received Set Wrench Effort"
    says controller "controller g: translated to an SDO download packet"
    says controller "g  -> station 3: SDO request"
}
several_masters() {
    local second third
    second=$(free_port) third=$(free_port)
    several_masters_on "udp:127.0.0.1:$slave_port" "udp:127.0.0.1:$second" "udp:127.0.0.1:$third"
    start_arm
    node robot_arm arm2 --ethercat-port "$second" && wait_for arm2 "waiting for a master"
    start_bus --ethercat-port "$third" --object 0x1B16:26=28
    start_several_masters
    each_command_reaches_its_slave
    # A slave that is gone holds nobody up.
    kill "$arm_pid" && wait "$arm_pid" 2>/dev/null
    forget "$arm_pid"
    wait_for controller "controller b: slave 2 does not answer"
    expect_ocu 0 --to 2.3.33.1 propulsive_linear_effort_y=100
    says arm2 "raw 32767"
    expect_ocu 1 --to 2.2.33.1 propulsive_linear_effort_x=20
    says controller "refused: the component is not ready"
    start_arm
    wait_for controller "controller b: 2.2.33.1: initialize -> ready" 2
    expect_ocu 0 --to 2.2.33.1 propulsive_linear_effort_x=30
    kill -INT "$controller_pid" && wait "$controller_pid"
    [ $? -eq 0 ] || fail "the controller does not end well on Ctrl-C"
    forget "$controller_pid"
    for system in b g h; do says controller "controller $system: stopped"; done
    expect 2 "$bin/robot_controller" --config "$config" --this b --ethercat-port "$slave_port"
    says out "--ethercat-port is not for b"
    expect 2 "$bin/robot_controller" --config "$config" --this b --station 4
}
a_master_may_start_without_its_slave() {
    several_masters_on "udp:127.0.0.1:$slave_port" "udp:127.0.0.1:$(free_port)" "udp:127.0.0.1:$(free_port)"
    start_arm
    master_options+=(--wait 300)
    start_several_masters
    says controller "controller g: ready: JAUS on 127.0.0.1"
    says controller "waiting for its slave: "
    expect_ocu 0 --to 2.2.33.1 propulsive_linear_effort_x=50
    expect_ocu 1 --to 2.3.33.1 propulsive_linear_effort_x=50
}
# master_ns has if_m and if_g, slave_ns has if_s; the ends of if_g and if_h are in namespaces of their own.
add_cable() { # INTERFACE NAMESPACE
    ip netns add "$2" && namespaces+=("$2")
    ip -n "$master_ns" link add "$1" type veth peer name if_s netns "$2" || fail "no veth pair $1"
    ip -n "$master_ns" link set "$1" up
    ip -n "$2" link set if_s up
}
several_masters_on_wires() {
    two_namespaces
    local second_ns=jc-2-$$ third_ns=jc-3-$$
    add_cable if_g "$second_ns"
    add_cable if_h "$third_ns"
    several_masters_on if_m if_g if_h
    prefix=(ip netns exec "$slave_ns")
    link=(--link raw --interface if_s)
    start_arm
    prefix=(ip netns exec "$second_ns")
    node robot_arm arm2 "${link[@]}" && wait_for arm2 "waiting for a master"
    prefix=(ip netns exec "$third_ns")
    start_bus "${link[@]}" --object 0x1B16:26=28
    prefix=(ip netns exec "$master_ns")
    start_several_masters
    says controller "controller g: raw Ethernet on if_g"
    each_command_reaches_its_slave
    # No thread of the program has kept the privilege that the sockets took.
    for task in /proc/"$controller_pid"/task/*/status; do
        grep -q '^CapEff:[[:space:]]*0*$' "$task" || fail "a thread has privileges: $task"
    done
    # A cable is cut: the others work on.
    ip -n "$slave_ns" link set if_s down
    wait_for controller "controller b: slave 2 does not answer"
    expect_ocu 0 --to 2.3.33.1 propulsive_linear_effort_y=100
    says arm2 "raw 32767"
    ip -n "$slave_ns" link set if_s up
    wait_for controller "controller b: 2.2.33.1: initialize -> ready" 2
    expect_ocu 0 --to 2.2.33.1 propulsive_linear_effort_x=30
}

at_rest() { # TIMES: so often the arm has shown that nothing drives it
    wait_for arm "received Set Wrench Effort, 36 bytes, 2.2.33.1 -> 2.2.33.1" "$1"
    for _ in $(seq 100); do
        [ "$(grep " raw " "$work/arm.log" | tail -12 | grep -c " raw 0$")" -eq 12 ] && return
        sleep 0.05
    done
    fail "the arm is not at rest"
}
states_bring_the_arm_to_rest() {
    start_robot
    expect_ocu 0 propulsive_linear_effort_x=50
    expect_ocu 0 --send standby
    says controller "2.2.33.1: standby: efforts go to zero"
    at_rest 2 # the first time when the slave came up
    expect_ocu 1 propulsive_linear_effort_x=20
    says controller "refused: the component is not ready"
    expect_ocu 0 --send resume
    expect_ocu 0 propulsive_linear_effort_x=30
    # Reset: at rest, and ready again, since there is a slave.
    expect_ocu 0 --send reset
    says controller "2.2.33.1: initialize -> ready"
    at_rest 3
    expect_ocu 0 propulsive_linear_effort_x=40
    # Who stops the machine lets it go on, and then it waits for a Resume. The arm hears of both.
    expect_ocu 0 --send set_emergency emergency_code=transition_to_emergency
    says controller "2.2.33.1: emergency: efforts go to zero"
    wait_for arm "EMERGENCY: all efforts to zero"
    expect_ocu 1 propulsive_linear_effort_x=20
    expect_ocu 0 --send clear_emergency emergency_code=clear_emergency
    wait_for arm "emergency cleared"
    expect_ocu 1 propulsive_linear_effort_x=20
    expect_ocu 0 --send resume
    the_command_arrives
    expect_ocu 0 --send shutdown
    says controller "2.2.33.1: shutdown: efforts go to zero"
    expect_ocu 1 propulsive_linear_effort_x=20
}
lost_controller_brings_the_arm_to_rest() {
    start_robot
    hold a propulsive_linear_effort_x=50
    wait_for controller "2.2.33.1 is controlled by 1.1.32.1, authority 128"
    wait_for controller "1.1.1.1 is heard"
    wait_for arm "raw 16384"
    dies "$unit_pid"
    wait_for controller "1.1.1.1 is no longer heard"
    wait_for controller "2.2.33.1 is controlled by nobody"
    says controller "2.2.33.1: its controller is lost: efforts go to zero"
    at_rest 2
    # Who releases control leaves the arm as it is.
    expect_ocu 0 propulsive_linear_effort_x=50
    wait_for controller "2.2.33.1 is controlled by nobody" 2
    expect_ocu 0 --query
    says out "propulsive_linear_effort_x = 50.001526 %"
}
emergency_while_the_slave_is_away() {
    two_namespaces
    start_raw_robot
    expect_ocu 0 propulsive_linear_effort_x=50
    ip -n "$slave_ns" link set if_s down
    wait_for controller "slave 2 does not answer"
    # Nobody can say that the arm has stopped: no acknowledgement.
    expect_ocu 1 --send set_emergency emergency_code=transition_to_emergency
    says out "no answer to Set Emergency"
    says controller "2.2.33.1: emergency: efforts go to zero when the slave is back"
    ip -n "$slave_ns" link set if_s up
    wait_for arm "EMERGENCY: all efforts to zero"
    says controller "2.2.33.1: the slave is back: efforts go to zero"
    wait_for controller "2.2.33.1: the slave has confirmed" 2
}
the_state_reaches_a_slave_with_process_data() {
    master_options+=("${cyclic[@]}")
    start_robot
    expect_ocu 0 propulsive_linear_effort_x=50
    expect_ocu 0 --send standby
    says controller "into the process image, command 3: 03 00 ff 0f 00 00 00 00 00 00"
    wait_for arm "efforts by process data, command 3"
    expect_ocu 0 --send resume
    the_command_arrives
}
components_of_the_configuration() {
    sed -i 's|<jausip>2.0.0.0</jausip>|&<node id="2"><component id="33" authority="7"/><component id="49"/></node>|' "$config"
    start_robot
    the_command_arrives
    # The arm has no objects of component 49: nobody knows what that does, so it is never ready.
    wait_for controller "2.2.49.1: the slave has not confirmed zero efforts, attempt 1: no such object in the dictionary"
    expect_ocu 1 --to 2.2.49.1 propulsive_linear_effort_x=1
    says controller "refused: the component is not ready"
    expect_ocu 0 --send query_component_authority
    says out "authority_code = 7"
}
a_component_behind_its_own_master_hears_of_losses() { # from the node manager, which is behind another
    local third
    third=$(free_port)
    several_masters_on "udp:127.0.0.1:$slave_port" "udp:127.0.0.1:$(free_port)" "udp:127.0.0.1:$third"
    start_arm
    start_bus --ethercat-port "$third" --object 0x1B16:26=28
    master_options+=(--wait 300)
    start_several_masters
    hold a --to 2.2.34.1 --send set_wrench_effort "${full_command[@]}"
    wait_for controller "controller h: 2.2.34.1 is controlled by 1.1.32.1"
    wait_for bus "0x1B16:26 ="
    wait_for controller "controller b: 1.1.1.1 is heard"
    dies "$unit_pid"
    wait_for controller "controller h: 2.2.34.1: its controller is lost: efforts go to zero"
    wait_for bus "0x1B16:26 =" 2
}
# Ctrl-C and SIGTERM: efforts must not outlive the program that commanded them.
the_end_of_the_controller_brings_the_arm_to_rest() {
    arm_options=(--command-timeout 0) # the controller does it
    for signal in INT TERM; do
        start_robot
        expect_ocu 0 propulsive_linear_effort_x=50
        kill -"$signal" "$controller_pid" && wait "$controller_pid"
        [ $? -eq 0 ] || fail "the controller does not end well on SIG$signal"
        forget "$controller_pid"
        says controller "2.2.33.1: the program ends: efforts go to zero"
        at_rest 2 # when the slave came up, and now
        kill "$arm_pid" && wait "$arm_pid"
        forget "$arm_pid"
    done
}
the_controller_ends_while_its_slave_is_silent() { # and says that nobody knows what the arm does
    arm_options=(--command-timeout 0)
    master_options+=("${end_options[@]}")
    start_robot
    expect_ocu 0 propulsive_linear_effort_x=50
    kill -STOP "$arm_pid"
    # Messages are answered meanwhile.
    expect_ocu 0 --send query_component_status
    local begun
    begun=$(date +%s%N)
    kill -INT "$controller_pid" && wait "$controller_pid"
    local code=$? took=$((($(date +%s%N) - begun) / 1000000))
    forget "$controller_pid"
    kill -CONT "$arm_pid"
    [ "$code" -eq 1 ] || fail "exit code $code for an arm that has not confirmed"
    [ "$took" -lt 5000 ] || fail "it took $took ms" # a second, but for a busy machine
    says controller "slave 2"
    says controller "has not confirmed that it is at rest"
}
the_cyclic_controller_ends_while_its_slave_is_silent() {
    end_options=("${cyclic[@]}")
    the_controller_ends_while_its_slave_is_silent
}
the_controller_is_killed() { # nobody is left to say anything: the arm's own timeouts
    arm_options=(--command-timeout 500)
    start_robot
    expect_ocu 0 propulsive_linear_effort_x=50
    dies "$controller_pid"
    wait_for arm "no message for 500 ms: all efforts to zero"
    master_options+=("${cyclic[@]}")
    start_controller
    expect_ocu 0 propulsive_linear_effort_x=50
    dies "$controller_pid"
    wait_for arm "no process data any more: all efforts to zero"
}
wrong_times_are_refused() {
    expect 2 "$bin/robot_controller" --config "$config" --this b --stop-within 19
    says out "--stop-within must be 20 to 60000"
    expect 2 "$bin/robot_controller" --config "$config" --this b --cycle 10000 --stop-within 6501
    says out "--stop-within must be 20 to 6500 with --cycle"
    expect 2 "$bin/robot_controller" --config "$config" --this b --cycle 10000 --stop-within 30
    says out "--stop-within must be at least 4 cycles"
}

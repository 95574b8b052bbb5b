#!/bin/sh
# Runs a command where two virtual Ethernet interfaces, jc0 and jc1, are joined by a cable: in a network namespace of its
# own, which ends with it. Root makes one directly, others inside a user namespace, where the machine permits that.
# Where that or a tool is missing the command is skipped; as root with CI=true that is a failure.
#
#   in_veth.sh [--needs TOOL]... COMMAND...
set -eu

skip() {
    if [ "$(id -u)" -eq 0 ] && [ "${CI:-}" = true ]; then
        echo "FAILED: $*" >&2
        exit 1
    fi
    echo "SKIPPED: $*"
    exit 0
}
while [ "${1:-}" = --needs ]; do
    command -v "$2" >/dev/null || skip "$2 is missing"
    shift 2
done

if [ "${1:-}" != --inside ]; then
    if [ "$(id -u)" -eq 0 ]; then options=--net; else options='--net --map-root-user'; fi
    # shellcheck disable=SC2086 # two options in one word
    reason=$(unshare $options ip link add jc0 type veth peer name jc1 2>&1) ||
        skip "no network namespace with a veth pair here: $reason"
    # shellcheck disable=SC2086
    exec unshare $options "$0" --inside "$@"
fi

shift
ip link set lo up
ip link add jc0 type veth peer name jc1
# Nothing but what the programs send: no IPv6 neighbour discovery.
for interface in jc0 jc1; do
    [ ! -e /proc/sys/net/ipv6/conf/$interface/disable_ipv6 ] || echo 1 >/proc/sys/net/ipv6/conf/$interface/disable_ipv6
    ip link set $interface up
done
# The kernel takes note of the cable a moment later, and loses frames before.
tries=0
until [ "$(ip link show type veth | grep -c 'state UP ')" -eq 2 ]; do
    tries=$((tries + 1))
    [ "$tries" -lt 1000 ] || skip "the veth pair does not come up"
    sleep 0.01
done
exec "$@"

#!/bin/sh
# Runs the raw link's test program where two virtual Ethernet interfaces, jc0 and jc1, are joined by a cable: in a
# network namespace of its own, which ends with it. Root makes one directly, others inside a user namespace, where the
# machine permits that. Otherwise the test is skipped; as root with CI=true that is a failure.
#
#   with_veth.sh PROGRAM
set -eu

if [ "${2:-}" != inside ]; then
    if [ "$(id -u)" -eq 0 ]; then set -- "$1" --net; else set -- "$1" '--net --map-root-user'; fi
    # shellcheck disable=SC2086 # two options in one word
    if reason=$(unshare $2 ip link add jc0 type veth peer name jc1 2>&1); then
        # shellcheck disable=SC2086
        exec unshare $2 "$0" "$1" inside
    fi
    if [ "$(id -u)" -eq 0 ] && [ "${CI:-}" = true ]; then
        echo "no network namespace with a veth pair: $reason" >&2
        exit 1
    fi
    echo "SKIPPED: no network namespace with a veth pair here: $reason"
    exit 0
fi

ip link set lo up
ip link add jc0 type veth peer name jc1
ip link set jc0 up
ip link set jc1 up
"$1" '[veth]'
setpriv --bounding-set -net_raw --inh-caps -net_raw "$1" '[unprivileged]'

#!/usr/bin/env bash
# collect.sh SCRIPT BIN: what scripts/collect-bus writes about emulated slaves.
set -uo pipefail
script=$1
export BIN=$2
work=$(mktemp -d)
bus=
trap '[ -z "$bus" ] || kill "$bus" 2>/dev/null; rm -rf "$work"' EXIT
fail() { echo "FAILED: $*" && cat "$work"/*.log && exit 1; }

for port in $((20000 + $$ % 20000)) $((20001 + $$ % 20000)) $((20002 + $$ % 20000)); do # one of them is free
    "$BIN/emulated_bus" --slaves 2 --outputs 4 --inputs 2 --ethercat-port "$port" >"$work/bus.log" 2>&1 &
    bus=$!
    until grep -q "waiting for a master" "$work/bus.log" || ! kill -0 $bus; do sleep 0.05; done 2>/dev/null
    ! grep -q "waiting for a master" "$work/bus.log" || break
done
"$script" "udp:127.0.0.1:$port" --seconds 1 --output "$work/bus.tar.gz" >"$work/out.log" 2>&1 || fail "exit code $?"
tar -xzf "$work/bus.tar.gz" -C "$work" || fail "it is no archive"
for part in computer.txt scan.json states.json cycles.json slave1.info.json slave1.sii.json slave1.sii.bin slave1.pdos.json \
    slave1.objects.json; do
    [ -s "$work/bus/$part" ] || fail "$part is missing"
done
[ ! -e "$work/bus/slave2.info.json" ] || fail "there is a third slave"
"$script" "udp:127.0.0.1:$port" --seconds 1 --operate --output "$work/bus.tar.gz" >"$work/out.log" 2>&1 || fail "exit code $? in OP"
grep -q "state op" "$work/bus.log" || fail "the slaves were not in OP"
kill "$bus" && wait "$bus"
bus=
"$script" "udp:127.0.0.1:$port" --seconds 1 --output "$work/none.tar.gz" >"$work/out.log" 2>&1 && fail "no error without slaves"
grep -q "missing: scan.json: .*no slave receives" "$work/out.log" || fail "it does not say what is missing"
"$script" --nonsense >"$work/out.log" 2>&1
[ $? -eq 2 ] || fail "a wrong command line"

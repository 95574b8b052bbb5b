#!/usr/bin/env bash
# full_output.sh FOLDER PROGRAM...: programs in FOLDER whose output cannot be written end with 1 and say so, also with --help.
# shellcheck disable=SC2086 # options are several words
set -uo pipefail
bin=$1
shift
work=$(mktemp -d)
bus=
trap '[ -z "$bus" ] || kill "$bus" 2>/dev/null; rm -rf "$work"' EXIT
[ -w /dev/full ] || { echo "SKIPPED: no /dev/full" && exit 0; }

failed=
full() { # COMMAND...
    timeout 30 "$@" >/dev/full 2>"$work/err" <"${input:-/dev/null}"
    local got=$?
    [ "$got" -eq 1 ] && grep -q "standard output cannot be written" "$work/err" && return
    echo "exit code $got: $*" && cat "$work/err" && failed=yes
}

for name in "$@"; do
    case $name in
    view_fields | dispatch | large_data | process_data | private_message | card_packets) full "$bin/$name" ;;
    *) full "$bin/$name" --help && full "$bin/$name" --version ;;
    esac
    case $name in
    jausdump)
        echo 0602050401210202012001010400220001000040 >"$work/message"
        for options in "" "--format json" "--summary" "--summary --format json" "--hex"; do
            input=$work/message full "$bin/jausdump" $options
        done
        ;;
    jauscat-esi)
        "$bin/jauscat-esi" --output "$work/slave.xml"
        full "$bin/jauscat-esi"
        full "$bin/jauscat-esi" --check "$work/slave.xml"
        ;;
    esac
done

case " $* " in *" emulated_bus "*) ;; *) [ -z "$failed" ] && exit 0 || exit 1 ;; esac
for _ in 1 2 3 4 5; do
    port=$((20000 + RANDOM % 12000))
    "$bin/emulated_bus" --ethercat-port "$port" --inputs 2 >"$work/bus" 2>&1 &
    bus=$!
    while kill -0 "$bus" 2>/dev/null && ! grep -q "Ctrl-C ends" "$work/bus"; do sleep 0.05; done
    kill -0 "$bus" 2>/dev/null && break
done
case " $* " in *" jauscat-ecat "*)
    ecat() { "$bin/jauscat-ecat" "$@" --link "udp:127.0.0.1:$port"; }
    for command in scan info state "read 0x1018:1 --slave 0" "sdos --slave 0" "sii --slave 0" "sii --slave 0 --hex" pdos \
        "monitor --seconds 0.1"; do
        for format in text json; do
            full "$bin/jauscat-ecat" $command --format "$format" --link "udp:127.0.0.1:$port"
        done
        full "$bin/jauscat-ecat" "${command%% *}" --help
    done
    ecat state safe-op --yes >"$work/out" 2>&1 || { cat "$work/out" && failed=yes; }
    full "$bin/jauscat-ecat" watch --link "udp:127.0.0.1:$port" # which would not end by itself
    ecat state init --yes >"$work/out" 2>&1 || { cat "$work/out" && failed=yes; }
    ;;
esac
case " $* " in *" cyclic "*) full "$bin/cyclic" --seconds 1 --ethercat-port "$port" ;; esac
[ -z "$failed" ]

#!/usr/bin/env bash
# figures.sh FOLDER: whether the figures at the beginning of its docs/performance.md are those of the tables below.
set -euo pipefail
cd "$1"
rows=0
cell() { # CELLS COLUMN: of the row of docs/performance.md that begins with CELLS; columns count after these
    sed -n "s/^| $1 | //p" docs/performance.md | awk -F ' *[|] *' -v column="$2" '{ print $column }'
}
median() { cell "$1" 2; }
flash=$(grep -oE '[0-9.]+ times the flash' docs/performance.md | tail -n 1)
read -r frame _ _ _ ratio <<<"$(cell 'datagram to frame, seed table (memcpy)' 1 | tr -d '*')"
read -r whole _ sockets _ <<<"$(cell 'socket to socket, seed table (sockets alone)' 1)"
actuator='JAUS datagram to actuator, by mailbox'
for row in \
    "| How long does a controller take from a JAUS datagram to the EtherCAT frame, without sockets? | $frame ns |" \
    "| How many datagrams in a second is that? | more than $(awk -v ns="$frame" 'BEGIN { print ns < 100 ? 10 : 1 }') million on one core |" \
    "| What does that cost, compared with a memcpy of the frame? | $ratio times the time |" \
    "| How long does it take with sockets on both sides? | $whole ns; the sockets alone take $sockets ns |" \
    "| How long until the actuator has the command, by SDO over virtual Ethernet? | $(median "$actuator") us (median), $(cell "$actuator" 3) us (99 %) |" \
    "| How many messages does a JAUS node answer in a second, with 8 outstanding? | $(cell 'jaus_node | 8' 1): $(cell 'jaus_node | 8' 2) of a bare UDP echo |" \
    "| SDO download on a raw link, two frames (by hand) | $(median 'SDO download of 28 bytes') us ($(median 'the two frames of that download, by hand')) |" \
    "| firmware node on a Cortex-M3, -Os, next to one written by hand | $flash |"; do
    rows=$((rows + 1))
    grep -qFx "$row" docs/performance.md || {
        echo "docs/performance.md has not: $row"
        failed=yes
    }
done
echo "$rows rows"
[ $rows -eq 8 ] && [ -z "${failed:-}" ]

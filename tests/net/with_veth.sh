#!/bin/sh
# Runs the raw link's test program on a veth pair, with its capability and without.
#
#   with_veth.sh PROGRAM
set -eu

if [ "${2:-}" != inside ]; then exec "$(dirname "$0")/../support/in_veth.sh" "$0" "$1" inside; fi
"$1" '[veth]'
setpriv --bounding-set -net_raw --inh-caps -net_raw "$1" '[unprivileged]'

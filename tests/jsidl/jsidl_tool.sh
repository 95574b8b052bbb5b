#!/bin/bash
# The tool jauscat-jsidl as a user runs it: jsidl_tool.sh TOOL CASE
set -u
tool=$1
data=$(cd "$(dirname "$0")/../data" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "FAILED: $*" >&2; exit 1; }
# expect CODE ARGS...: runs the tool, and keeps what it says in $work/out and $work/err
expect() {
    local code=$1 got=0
    shift
    "$tool" "$@" >"$work/out" 2>"$work/err" || got=$?
    [ "$got" -eq "$code" ] || fail "$* ended with $got instead of $code: $(cat "$work/out" "$work/err")"
}
says() { grep -qF -- "$1" "$work/out" "$work/err" || fail "'$1' is not in: $(cat "$work/out" "$work/err" | head -50)"; }

writes_and_checks() {
    expect 0 --help
    says "Examples:"
    expect 0 "$data/sonar.xml" --output "$work/a" --write-facts "$work/facts.txt"
    [ ! -s "$work/out" ] || fail "it writes to standard output, too"
    expect 0 --facts "$work/facts.txt" --output "$work/b"
    diff -r "$work/a" "$work/b" || fail "the table of facts makes other headers"
    expect 0 "$data/sonar.xml" --check "$work/a"
    says "3 headers are current"
    echo "// changed" >>"$work/a/survey.hpp"
    rm "$work/a/ranges.hpp"
    cp "$work/a/survey/sonar.hpp" "$work/a/survey/lidar.hpp"
    echo "// by hand" >"$work/a/own.hpp"
    expect 1 "$data/sonar.xml" --check "$work/a"
    says "survey.hpp: differs from what jauscat-jsidl writes"
    says "ranges.hpp: is missing"
    says "lidar.hpp: is of a service that is not given"
    grep -q own.hpp "$work/out" && fail "it complains about a header by hand"
    expect 0 --facts "$data/sae_facts.txt" --write-facts "$work/again.txt"
    diff <(grep -v '^#' "$data/sae_facts.txt") "$work/again.txt" || fail "the table of facts is not as the tool writes it"
}

capacities() {
    expect 0 "$data/sonar.xml" --capacity 8 --capacity ReportEchoes.EchoList=40 --namespace acme --include-prefix acme --output "$work"
    diff "$work/survey/sonar.hpp" "$data/sonar.hpp.golden" || fail "the header differs from the golden one"
    expect 2 "$data/sonar.xml" --capacity many --output "$work"
    says "--capacity must be a number or LIST=NUMBER, not 'many'"
    expect 1 "$data/sonar.xml" --capacity Other=4 --output "$work"
    says 'there is no list "Other" for a capacity'
}

wrong_arguments() {
    expect 2
    says "no JSIDL file, and no --facts"
    expect 2 "$data/sonar.xml"
    says "nothing to do: give --output, --check or --write-facts"
    expect 2 "$data/sonar.xml" --facts "$data/sae_facts.txt" --output "$work/a"
    says "exclude each other"
    expect 2 --no-such-option
    says "Try 'jauscat-jsidl --help'"
}

broken_files() {
    expect 1 "$work/none.xml" --output "$work/a"
    says "none.xml: cannot be read: No such file or directory"
    expect 1 "$data/sonar.xml" "$data/sonar.xml" --output "$work/a"
    says "sonar.xml:3: <service_def>: defines urn:acme:jss:survey:Sonar version 1.2 again"
    sed 's/10,000/10,00/' "$data/sonar.xml" >"$work/sonar.xml"
    expect 1 "$work/sonar.xml" --output "$work/a"
    says 'sonar.xml:42: <scale_range>: real_upper_limit="10,00", expected a number'
    [ ! -e "$work/a" ] || fail "it writes headers of a definition that it refuses"
    expect 1 "$data/sonar.xml" --output "$data/sonar.xml/a"
    says "cannot be written"
}

$2

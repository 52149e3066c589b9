# shellcheck shell=sh
# What the scripts of this folder share: `. "$(dirname "$0")/case.sh"`. Each gets Frond (or for unit.sh the build) as its
# first argument, some a folder as the $second, works in a folder of its own, $work, and ends with `verdict`.
set -u
frond=$(realpath "$1") || exit 1
# shellcheck disable=SC2034 # of some
here=$(realpath "$(dirname "$0")") || exit 1
# shellcheck disable=SC2034 # of some
second=$(realpath "${2-.}") || exit 1
work=$(mktemp -d) || exit 1
running='' broker='' # processes in the background, which end with the script
# shellcheck disable=SC2086 # words
trap '[ -z "$running$broker" ] || kill $running $broker 2>/dev/null; rm -rf "$work"' EXIT
XDG_STATE_HOME=$work/state
export XDG_STATE_HOME
unset STATE_DIRECTORY
timeout=$(command -v timeout) || exit 1 # scripts may take away the PATH
patience=${FROND_PATIENCE:-1} # how much longer everything takes here: tests/sanitized.cmake
failures=0

fail() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$1"
    for said in "$work"/out.txt "$work"/err.txt "$work"/broker.log; do
        [ ! -f "$said" ] || tail -n 40 "$said" | sed "s/^/  ${said##*/}: /"
    done
}

skip() {
    echo "SKIPPED: $1"
    exit 77
}

verdict() {
    [ "$failures" -eq 0 ] || exit 1
    exit 0
}

# expect STATUS ARGUMENTS...: runs frond without a terminal; leaves out.txt and err.txt.
expect() {
    wanted=$1
    shift
    last="frond $*"
    "$timeout" $((200 * patience)) "$frond" "$@" >out.txt 2>err.txt </dev/null
    status=$?
    [ "$status" -eq "$wanted" ] || fail "$last: exit status $status, not $wanted"
}

says() { # the whole of stderr
    [ "$(cat err.txt)" = "$1" ] || fail "$last: stderr is not: $1"
}

says_line() { # a line of stderr, as a basic regular expression
    grep -q -- "^$1\$" err.txt || fail "$last: does not say: $1"
}

# wait_until COMPLAINT COMMAND...: until the command is true; only what hangs takes as long as it waits at most.
wait_until() {
    complaint=$1 left=$((600 * patience)) # tenths of a second, or more
    shift
    until "$@" 2>/dev/null; do
        left=$((left - 1))
        [ "$left" -gt 0 ] || {
            fail "$complaint"
            return 1
        }
        sleep 0.1
    done
}

wait_for() { # wait_for PATTERN [FILE]: until a line of stderr, or of FILE, says so
    wait_until "${2-err.txt} never said: $1" grep -q -- "$1" "${2-err.txt}"
}

says_times() { # says_times COUNT PATTERN: so many lines of stderr, or more
    [ "$(grep -c -- "$2" err.txt)" -ge "$1" ]
}

size_of() { # WIDTHxHEIGHT of a PNG, from its header
    od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'
}

cd "$work" || exit 1

# shellcheck shell=bash
# What the programs of scenarios share. Such a program is started here; it boots the machine, which starts it again inside,
# where one scene after the other is played. Then what was seen of each from outside is looked at here.
#
#     tests/kernel/display_virtio LIMIT BUILD OUT [SCENE...]
#     tests/kernel/display_virtio 120 build/release /tmp/look frames        one scene of it, by hand
#
#     source "$(dirname "${BASH_SOURCE[0]}")/scenario.bash"
#     boot=(--gpu virtio)                                      options of `machine run`
#     scenes=(frames)
#     frames() {                                               inside
#         start probe "$build/..." --frames 20                 its output goes to probe.log in OUT
#         check "a frame is shown" await probe 'frame 1'
#         check "a screenshot is taken" outside shot first     first.png in OUT
#     }
#     frames_before() { ...; }                                 here, before; may be left out
#     frames_after() {                                         here, after; may be left out
#         check "the screen shows what was drawn" same drawn.png first.png
#     }
#     scenario "$@"
#
# Every check is a line of the test's output: `ok` or `FAILED`, and the time. A failed one does not end the scenario, so
# that one run tells all; what the logs say anew is shown with it.
set -uo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
failures=0
declare -A shown=() # bytes of each log that a failed check has printed
declare -A pid=() # of what `start` has started, by name

check() { # check WHAT COMMAND...
    local what=$1 said size
    shift
    if "$@"; then
        printf 'ok  %3d s  %s\n' $SECONDS "$what"
        return 0
    fi
    failures=$((failures + 1))
    printf 'FAILED %3d s  %s: %s\n' $SECONDS "$what" "$*"
    for said in "$out"/*.log; do
        size=$(stat -c %s "$said")
        if ((size > ${shown[$said]:-0})); then
            printf -- '---- %s\n' "${said##*/}"
            tail -c +$((${shown[$said]:-0} + 1)) "$said" | tail -n 12
            printf -- '----\n'
        fi
        shown[$said]=$size
    done
    return 1
}
equal() { # equal FOUND WANTED
    [[ $1 == "$2" ]] || { printf '        found "%s", wanted "%s"\n' "$1" "$2" && false; }
}
within() { # within LEAST VALUE MOST: whole numbers
    (($1 <= $2 && $2 <= $3)) || { printf '        %s is not within %s..%s\n' "$2" "$1" "$3" && false; }
}

# ---- programs in the background, here or inside

start() { # start NAME COMMAND...; what `tell` says is its standard input
    local name=$1
    shift
    rm -f "$scratch/$name.in"
    mkfifo "$scratch/$name.in"
    : >"$out/$name.log"
    exec {stdin}<>"$scratch/$name.in"
    "$@" <&"$stdin" >"$out/$name.log" 2>&1 &
    pid[$name]=$!
    exec {stdin}>&-
}
tell() { # tell NAME LINE
    printf '%s\n' "$2" >"$scratch/$1.in"
}
patience=180 # seconds that one thing is waited for: only what hangs takes so long, however slow the machine is
# Until a line of the log holds the pattern; only lines after those that the last `await` of that name has seen.
declare -A seen=()
await() { # await NAME PATTERN
    local end=$((SECONDS + patience)) line at
    local -a lines
    while :; do
        mapfile -t lines <"$out/$1.log"
        for ((at = ${seen[$1]:-0}; at < ${#lines[@]}; at++)); do
            line=${lines[at]}
            if [[ $line =~ $2 ]]; then
                seen[$1]=$((at + 1))
                return 0
            fi
        done
        ((SECONDS < end)) || return 1
        pause 0.1
    done
}
pause() { # sleeps without a process
    read -r -t "$1" <>"$scratch/clock" || true
}
becomes() { # becomes WANTED COMMAND...: until the command prints that
    local end=$((SECONDS + patience))
    until [[ $("${@:2}") == "$1" ]]; do
        ((SECONDS < end)) || equal "$("${@:2}")" "$1" || return
        pause 0.1
    done
}
ended() { # ended NAME STATUS: it ends, with that status
    local end=$((SECONDS + patience)) status=0
    while kill -0 "${pid[$1]}" 2>/dev/null; do
        ((SECONDS < end)) || return 1
        pause 0.1
    done
    wait "${pid[$1]}" || status=$?
    equal "$status" "$2"
}
# As the command of that name, without its three processes. For one asker at a time: the scene, while no probe asks.
outside() {
    local status reply control
    exec {control}<>/dev/machine.control
    printf '%s\n' "$*" >&"$control"
    read -r status reply <&"$control"
    exec {control}>&-
    [[ ! $reply ]] || printf '%b\n' "$reply"
    return "$status"
}
# Flips that the kernel has reported to programs since `flips_from_now`; the console's have no file.
flips_from_now() {
    [[ -d /sys/kernel/tracing/events ]] || mount -t tracefs tracefs /sys/kernel/tracing
    printf 0 >/sys/kernel/tracing/trace
    printf 1 >/sys/kernel/tracing/events/drm/drm_vblank_event_delivered/enable
}
flips() {
    grep 'drm_vblank_event_delivered:' /sys/kernel/tracing/trace | grep -vc 'file=0*,'
}
await_flips() { # await_flips COUNT
    local end=$((SECONDS + patience))
    until (($(flips) >= $1)); do
        ((SECONDS < end)) || return 1
        pause 0.3
    done
}
descriptors() { # descriptors NAME: how many files it has open
    local -a open=("/proc/${pid[$1]}/fd/"*)
    printf '%d\n' ${#open[@]}
}
up_us() { # microseconds since the machine began, in steps of 10 ms, rounded up
    local seconds parts
    IFS='. ' read -r seconds parts _ </proc/uptime
    printf '%d\n' $((1000000 * seconds + 10000 * (10#$parts + 1)))
}
resident() { # resident NAME: memory in KiB
    awk '/^VmRSS:/ { print $2 }' "/proc/${pid[$1]}/status"
}

# ---- here, afterwards

same() { # same [OPTIONS] DRAWN SHOWN: files of OUT; prints by how much they differ
    local -a arguments=("$@")
    local last=$(($# - 1))
    arguments[last]=$out/${arguments[last]}
    arguments[last - 1]=$out/${arguments[last - 1]}
    printf '        %s, %s: ' "${*: -2:1}" "${*: -1}"
    "$build/tests/kernel/picture_compare" "${arguments[@]}"
}
different() {
    local status=0
    same "$@" || status=$?
    ((status == 1))
}

boot=()
scenes=()

# Plays NAME or NAME_before or NAME_after of each scene, where there is one.
play() { # play SUFFIX
    local scene
    for scene in "${scenes[@]}"; do
        ! declare -F "$scene$1" >/dev/null || "$scene$1"
    done
}
end_all() {
    local name
    for name in "${!pid[@]}"; do
        kill "${pid[$name]}" 2>/dev/null
    done
    rm -rf "$scratch"
}
scenario() {
    local status=0 within=${MACHINE_OUT:-}
    if (($# < 3)); then
        printf '%s LIMIT BUILD OUT [SCENE...]\n' "$0" >&2
        exit 2
    fi
    build=$(realpath "$2") out=${within:-$3}
    (($# == 3)) || scenes=("${@:4}")
    if ! declare -F "${scenes[@]}" >/dev/null; then
        printf '%s: one of these is no scene: %s\n' "$0" "${scenes[*]}" >&2
        exit 2
    fi
    scratch=$(mktemp -d)
    trap end_all EXIT
    mkfifo "$scratch/clock"
    if [[ $within ]]; then
        play ''
        exit $((failures > 0))
    fi
    "$here/machine" prepared || exit
    rm -rf "$out"
    mkdir -p "$out"
    play _before
    "$here/machine" run --prepared --limit "$1" --out "$out" "${boot[@]}" -- \
        "$(realpath "$0")" "$1" "$build" "$3" "${scenes[@]}" || status=$?
    ((status <= 1)) || printf 'FAILED  the machine or the scenario ended with %d\n' "$status"
    ((status == 0)) || failures=$((failures + 1))
    play _after
    printf '%s\n' "screenshots and logs: $out"
    exit $((failures > 0))
}

#!/bin/sh
# `frond run` on a display in memory, and the engine of the GPU: what is said, what is left behind. live.sh FROND DATA
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
data=$second

cp "$data"/sessions/one-drop.yaml .

# Options that are wrong.
for pair in "display:screen:one of auto, kms, window, headless, none" "rotate:45:0, 90, 180 or 270 degrees" \
    "engine:abacus:one of auto, cpu, gpu" "rate:0:1 to 1000 ticks a second" "frames:0:1 to 10000000 frames" \
    "mode:640:WxH or WxH@HZ, each side 1 to 8192 pixels" "mode:640x480@x:WxH or WxH@HZ, each side 1 to 8192 pixels"; do
    option=${pair%%:*} rest=${pair#*:}
    expect 2 run one-drop.yaml "--$option" "${rest%%:*}"
    says_line "frond run: --$option: '${rest%%:*}' is not it; ${rest#*:}"
done
expect 1 run one-drop.yaml --display kms --card /dev/null
grep -q '^frond run: kms: ' err.txt || fail "$last: no reason"

# Live: so many frames, the last of them as a picture, turned or not.
expect 0 run one-drop.yaml --display headless --mode 192x128 --ticks 40 --once --engine cpu --frames 3 --shot a.png
says_line "frond: display: headless, 192x128; asked for"
says_line "frond: engine cpu: asked for"
says_line "frond: 3 frames presented, .*"
[ "$(size_of a.png)" = 192x128 ] || fail "$last: the shot is $(size_of a.png)"
expect 0 run one-drop.yaml --display headless --mode 192x128 --rotate 90 --ticks 20 --once --frames 2 --shot b.png
says_line "frond: engine [cg]pu: .*"
[ "$(size_of b.png)" = 128x192 ] || fail "$last: the shot is $(size_of b.png)"
expect 0 run one-drop.yaml --display headless --mode 160x120 --ticks 20 --once --frames 2 --xray --shot c.png
[ "$(size_of c.png)" = 160x120 ] || fail "$last: the shot is $(size_of c.png)"
expect 1 run one-drop.yaml --display headless --ticks 5 --once --frames 1 --engine cpu --shot no/d.png
grep -q '^frond: no/d.png: ' err.txt || fail "$last: no reason"

# It ends by a signal, politely.
"$frond" run one-drop.yaml --display headless --mode 64x48 --engine cpu >out.txt 2>err.txt &
wait_for "engine cpu"
kill -TERM $!
wait $!
status=$?
last="SIGTERM"
[ "$status" -eq 0 ] || fail "$last: exit status $status"
says_line "frond: [0-9]* frames presented, .*"

# The engine of the GPU paints the same picture as that of the CPU: of what is carved, a cell in a hundred at most differs.
expect 0 render one-drop.yaml -o cpu.png --ticks 60 --stats cpu.json
expect 0 render one-drop.yaml -o gpu.png --ticks 60 --stats gpu.json --engine gpu
grep -q '"engine": "gpu"' gpu.json || fail "$last: another engine"
grep -q '"hash": null' gpu.json || fail "$last: a hash that it cannot repeat"
area() { sed -n 's/.*"area": *\([0-9]*\).*/\1/p' "$1"; }
cpu=$(area cpu.json) gpu=$(area gpu.json)
if [ "$cpu" -le 100 ] || [ $((100 * (gpu - cpu))) -gt "$cpu" ] || [ $((100 * (cpu - gpu))) -gt "$cpu" ]; then
    fail "areas of $cpu and $gpu cells"
fi
expect 1 render one-drop.yaml -o e.png --ticks 2 --engine gpu --shaders "$work"
grep -q 'no such shader source' err.txt || fail "$last: no reason"

verdict

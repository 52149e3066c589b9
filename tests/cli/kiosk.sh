#!/bin/sh
# `frond run` with an exhibit on a display in memory: it paints by itself, takes up what a curator writes while it runs,
# and keeps what it has when that is wrong. kiosk.sh FROND EXHIBITS
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
exhibits=$second

# Every exhibit that comes with Frond.
for exhibit in "$exhibits"/*.yaml; do
    name=$(basename "$exhibit" .yaml)
    timeout $((200 * patience)) "$frond" run "$exhibit" --display headless --mode 320x200 --rotate 0 --engine cpu --full --open --frames 12 \
        --state "$work/state" --shot "$name.png" >out.txt 2>err.txt </dev/null || fail "run $name: exit status $?"
    [ -s "$name.png" ] || fail "run $name: no picture"
    grep -q "12 frames presented" err.txt || fail "run $name: not 12 frames"
done
[ -z "$(find "$work/state" -type f 2>/dev/null)" ] || fail "attract has written something"

# Hot reload.
printf 'exhibit: 1\nvisit: {idle: 60}\n' >own.yaml
timeout $((400 * patience)) "$frond" run own.yaml --display headless --mode 320x200 --engine cpu --state "$work/state" \
    >out.txt 2>err.txt </dev/null &
running=$!
wait_for "visit 0: attract"
printf 'exhibit: 1\nvisit: {idle: 30}\n' >own.yaml
wait_for 'own.yaml: taken up [0-9]* ms after it was changed'
printf 'reload: %s ms\n' "$(sed -n 's/.*taken up \([0-9]*\) ms after.*/\1/p' err.txt)"
printf 'exhibit: 1\nvisti: {idle: 30}\n' >own.yaml
wait_for "the exhibit stays as it was"
wait_for "own.yaml:2:1: visti: unknown key; did you mean visit?"
kill -0 "$running" 2>/dev/null || fail "a wrong file has ended it"
printf 'exhibit: 1\nvisit: {idle: 40}\n' >own.yaml.new && mv own.yaml.new own.yaml # as editors do
wait_until "the mended file is not taken up" says_times 2 'taken up'
kill -TERM "$running"
wait "$running" || fail "it ended with status $?"
running=

# A service never ends by its exhibit: one that is wrong or not there is waited for. Its status stands in files while it
# runs, and its log has levels where it goes to the journal.
rm -f own.yaml
mkdir -p status
: >err.txt
JOURNAL_STREAM=$(stat -c %d:%i err.txt) RUNTIME_DIRECTORY=$work/status timeout $((400 * patience)) "$frond" run own.yaml --standby \
    --display headless --mode 320x200 --engine cpu --state "$work/state" >out.txt 2>>err.txt </dev/null &
running=$!
wait_for "^<4>the exhibit cannot be shown"
wait_for "^<4>own.yaml: cannot be read: No such file"
wait_for '"exhibit_wrong":true' status/status.json
printf 'exhibit: 1\nscenes: [{id: dawn}]\n' >own.yaml
wait_for "^<6>own.yaml: taken up"
wait_for '"scene":"dawn"' status/status.json
wait_for '^frond_exhibit_wrong 0' status/frond.prom
[ "$(stat -c %a status/status.json status/frond.prom | sort -u)" = 644 ] || fail "not everybody may read the status"
kill -TERM "$running"
wait "$running" || fail "it ended with status $?"
running=
[ -z "$(ls status)" ] || fail "what has ended still has a status"

verdict

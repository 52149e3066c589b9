#!/bin/sh
# `frond report`: everything that it promises, and nothing about people. report.sh FROND EXHIBITS
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
exhibits=$second

# A machine with a telling name, where that can be had, an owner, and an exhibit in which both have left their traces.
host=salle-sept
unshare --uts true 2>/dev/null && apart="unshare --uts" || apart="unshare --user --map-root-user --uts"
$apart true 2>/dev/null || {
    apart=
    host=$(uname -n)
}
printf '# Made by valentina on %s.\n# valentina@museum.example, 192.168.7.21, fe80::1c2d:3eff:fe4f:5061, 02:00:5e:10:00:ff\n' "$host" >own.yaml
printf '# %s, /home/valentina/exhibit.yaml\nexhibit: 1\n' "$(cat /etc/machine-id 2>/dev/null || echo 0123456789abcdef0123456789abcdef)" >>own.yaml
mkdir status
printf '{"frond": "1", "state": "attract"}\n' >status/status.json
printf 'frond_visits_total 3\n' >status/frond.prom
# shellcheck disable=SC2086 # words
${apart:-env} sh -c '[ -z "$0" ] || hostname "$1" 2>/dev/null || echo "$1" >/proc/sys/kernel/hostname; shift
    USER=valentina exec "$@"' "$apart" "$host" "$frond" report own.yaml --status status -o a.tar.gz >out.txt 2>err.txt ||
    fail "exit status $?: $(cat err.txt)"
[ "$(cat out.txt)" = a.tar.gz ] || fail "it does not say where it is"
tar -tvzf a.tar.gz >list.txt || fail "tar does not take it"
tar -xzf a.tar.gz || fail "tar does not unpack it"
for name in version.txt exhibit.yaml check.txt status.json frond.prom devices.txt board.txt journal.txt; do
    [ -f "frond-report/$name" ] || fail "no $name"
    "$frond" report --help | grep -q "$name" || fail "help does not tell of $name"
done
[ "$(find frond-report -type f | wc -l)" -eq 8 ] || fail "more than it promises: $(ls frond-report)"
grep -q '^exhibit: 1$' frond-report/exhibit.yaml || fail "the exhibit is not there"
grep -q 'all is well' frond-report/check.txt || fail "the exhibit is not checked"
grep -q '"state": "attract"' frond-report/status.json || fail "no status"
grep -q "^frond [0-9]" frond-report/version.txt || fail "no version"
grep -q '^ID=' frond-report/version.txt || fail "no system"

# By no spelling: host, user, addresses, unique numbers.
for word in "$host" valentina museum.example 192.168.7.21 fe80 02:00:5e "$(cat /etc/machine-id 2>/dev/null)" \
    "$(cat /proc/sys/kernel/random/boot_id)" $(cat /sys/class/net/*/address 2>/dev/null | grep -v '^00:00:00:00:00:00$'); do
    [ -z "$word" ] || ! grep -rqi -- "$word" frond-report || fail "it tells '$word': $(grep -rhi -- "$word" frond-report | head -1)"
done
grep -qv ' 0/0 ' list.txt && fail "files have owners"
grep -q 'Made by \[user\] on \[host\]' frond-report/exhibit.yaml || fail "what was taken out has left no mark"

# A broken exhibit, and one that is not there, are told, not an end.
printf 'exhibit: 1\nvisti: {}\n' >own.yaml
"$frond" report own.yaml --status nowhere -o b.tar.gz >out.txt 2>err.txt || fail "no report of a broken exhibit"
tar -xzf b.tar.gz && grep -q 'own.yaml:2:1: visti' frond-report/check.txt || fail "what is wrong is not told"
"$frond" report "$exhibits/none.yaml" -o c.tar.gz >out.txt 2>err.txt || fail "no report without an exhibit"
"$frond" report -o nowhere/d.tar.gz >out.txt 2>err.txt && fail "a file that cannot be written"
grep -q '^frond report: nowhere/d.tar.gz: ' err.txt || fail "it does not say why"
"$frond" report a b >out.txt 2>err.txt
[ $? -eq 2 ] || fail "two exhibits"

verdict

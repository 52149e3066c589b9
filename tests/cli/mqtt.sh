#!/bin/sh
# A kiosk and a real broker (Mosquitto) on loopback, with TLS by a certificate authority that lives as long as this test:
# status, heartbeat and last will; a scene and opening hours from afar; wrong credentials and certificates, and a broker
# that goes and comes. mqtt.sh FROND
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
PATH=$PATH:/usr/sbin
for program in mosquitto openssl; do
    command -v "$program" >/dev/null || skip "no $program"
done
strings "$frond" 2>/dev/null | grep -q "built without MQTT" && skip "built without MQTT"

# An authority, the broker's certificate and the kiosk's.
authority() { # authority NAME
    openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj "/CN=$1" -keyout "$1.key" \
        -out "$1.pem" 2>/dev/null
}
certificate() { # certificate NAME COMMON-NAME
    printf 'subjectAltName=DNS:localhost,IP:127.0.0.1\n' >ext
    openssl req -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj "/CN=$2" -keyout "$1.key" -out "$1.csr" 2>/dev/null &&
        openssl x509 -req -in "$1.csr" -CA ca.pem -CAkey ca.key -CAcreateserial -days 2 -extfile ext -out "$1.pem" 2>/dev/null
}
authority ca && authority other && certificate broker localhost && certificate hall hall || fail "no certificates"
mosquitto_passwd -c -b passwords hall secret 2>/dev/null || fail "no password file"
mosquitto_passwd -b passwords staff secret
printf 'hall\nsecret\n' >hall.txt
printf 'hall\nwrong\n' >wrong.txt
chmod 644 ./*

port=$((20000 + $$ % 20000))
cat >broker.conf <<CONF
listener $port 127.0.0.1
cafile $work/ca.pem
certfile $work/broker.pem
keyfile $work/broker.key
require_certificate true
allow_anonymous false
password_file $work/passwords
log_dest stderr
log_type all
user root
CONF
begin_broker() {
    mosquitto -c broker.conf >>broker.log 2>&1 &
    broker=$!
}
client() { # client PROGRAM ARGUMENTS: as the staff does it
    program=$1
    shift
    timeout $((60 * patience)) "$program" -h localhost -p "$port" --cafile ca.pem --cert hall.pem --key hall.key -u staff -P secret "$@"
}
is_alive() { # is_alive 1, or 0: as the broker has it
    [ "$(client mosquitto_sub -t museum/frond/hall/alive -C 1)" = "$1" ]
}
tells_scene() {
    client mosquitto_sub -t museum/frond/hall/status -C 1 | grep -q "\"scene\":\"$1\""
}
command -v mosquitto_sub >/dev/null || skip "no mosquitto_sub: apt-get install mosquitto-clients"
exhibit() { # exhibit CREDENTIALS CA
    cat >own.yaml.new <<YAML
exhibit: 1
visit: {attract: 1800, wash: 1}
scenes: [{id: dawn}, {id: dusk}]
mqtt: {host: localhost, port: $port, topic: museum/frond, name: hall, group: all, every: 5, ca: $2, certificate: hall.pem,
  key: hall.key, credentials: $1}
YAML
    mv own.yaml.new own.yaml
}

: >err.txt
: >broker.log
exhibit wrong.txt ca.pem
"$frond" check own.yaml || fail "the exhibit is wrong"
timeout $((600 * patience)) "$frond" run own.yaml --display headless --mode 160x100 --engine cpu --full --rate 240 --state state >out.txt 2>err.txt </dev/null &
running=$!
# No broker yet: said, and nothing else comes of it.
wait_for "broker localhost: cannot be reached"
begin_broker
# A wrong password, then an authority that has not signed it, then all is well: as the exhibit is edited.
wait_for "broker localhost: refuses: "
exhibit hall.txt other.pem
wait_for "own.yaml: taken up"
wait_for "broker localhost: .*TLS"
wait_for "certificate verify failed\|unknown ca\|bad certificate" broker.log
grep -q "broker localhost: connected" err.txt && fail "it talks to a broker that a stranger has signed"
exhibit hall.txt ca.pem
wait_for "broker localhost: connected"

# Status and heartbeat.
wait_until "it is not alive" is_alive 1
client mosquitto_sub -t museum/frond/hall/status -C 1 >status.json
grep -q '"state":"attract"' status.json || fail "no status: $(cat status.json)"
grep -q '"scene":"dawn"' status.json || fail "no scene"
python3 -c 'import json; json.load(open("status.json"))' || fail "it is no JSON"
client mosquitto_sub -t museum/frond/hall/status -R -C 1 >again.json # a new one, not the retained one
grep -q '"uptime_s"' again.json || fail "no heartbeat"

# A scene for the group, and one that is not there; hours.
client mosquitto_pub -t museum/frond/all/scene -m noon
wait_for "says what is not known here, 'noon'"
client mosquitto_pub -t museum/frond/all/scene -m dusk
wait_for "museum/frond/all/scene says 'dusk'"
client mosquitto_pub -t museum/frond/hall/hours -m closed
wait_for "visit [0-9]*: closed"
client mosquitto_pub -t museum/frond/hall/hours -m schedule
wait_until "it stays closed" says_times 2 'visit [0-9]*: attract'
wait_until "the scene stays" tells_scene dusk

# The broker goes and comes.
kill "$broker"
wait "$broker" 2>/dev/null
wait_for "broker localhost: lost"
begin_broker
wait_until "it does not come back" says_times 2 'broker localhost: connected'
# Goodbye, and the last will.
kill -TERM "$running"
wait "$running" || fail "it ended with status $?"
running=
wait_until "it is still alive" is_alive 0
timeout $((600 * patience)) "$frond" run own.yaml --display headless --mode 160x100 --engine cpu --state state >out.txt 2>err.txt </dev/null &
running=$!
wait_until "it is not alive again" is_alive 1
kill -KILL "$(pgrep -P "$running" -x frond)" 2>/dev/null || kill -KILL "$running"
wait "$running" 2>/dev/null
running=
wait_until "a killed one has left no will" is_alive 0
grep -q secret err.txt && fail "the log tells the password"
verdict

#!/bin/sh
# The unit of the service, as it is installed below a prefix: systemd takes it, and finds little that it may do beyond its
# work (`systemd-analyze security`, of 0 to 10; the bare unit has 9.6). unit.sh BUILD
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
build=$frond
command -v systemd-analyze >/dev/null || skip "no systemd-analyze: apt-get install systemd"
cmake --install "$build" --prefix "$work/root" >"$work/log" 2>&1 || {
    cat "$work/log"
    exit 1
}
unit=$work/root/lib/systemd/system/frond.service
[ -x "$work/root/bin/frond" ] || fail "no program"
grep -q "^ExecStart=$work/root/bin/frond run .* $work/root/etc/frond/exhibit.yaml$" "$unit" || fail "it starts another program"
grep -q '@[a-zA-Z_]*@' "$unit" && fail "something was not filled in"
said=$(systemd-analyze verify --recursive-errors=no "$unit" 2>&1) || fail "systemd refuses it"
[ -z "$said" ] || fail "systemd complains: $said"

# At most 1.5.
systemd-analyze security --offline=true --threshold=15 --no-pager "$unit" >"$work/security" 2>&1 || fail "it may do too much"
sed -n 's/^.*\(Overall exposure level.*\)/\1/p' "$work/security"
# Each thing that it may do stands in the unit, with the reason.
sed -n '/^# Left out, and why:/,/^$/p' "$unit" >"$work/reasons"
for word in $(sed -n 's/^✗ \([A-Za-z]*\)=.*/\1/p' "$work/security" | sort -u); do
    case $word in
    SupplementaryGroups | DeviceAllow | RestrictAddressFamilies) grep -B 4 "^$word=" "$unit" | grep -q '^#' ;;
    *) grep -q "$word=" "$work/reasons" ;;
    esac || fail "$word= is left out without a reason"
done
# What the kiosk is promised (README, platform/touch/source_touch.h).
for line in Type=notify WatchdogSec=10 Restart=always RestartSec=1 StartLimitIntervalSec=300 StartLimitBurst=5 \
    StartLimitAction=reboot LimitCORE=0 TTYReset=yes Conflicts=getty@tty1.service ProtectSystem=strict; do
    grep -qx "$line" "$unit" || fail "no $line"
done

# With the drop-in for MQTT, too.
cp "$unit" "$work/frond.service" && mkdir "$work/frond.service.d" && cp "$work/root/share/frond/mqtt.conf" "$work/frond.service.d/"
sed -n '/^\[Service\]/,$p' "$work/frond.service.d/mqtt.conf" | sed 1d >"$work/more"
sed -i "/^SystemCallErrorNumber=/r $work/more" "$work/frond.service"
rm -r "$work/frond.service.d"
systemd-analyze security --offline=true --threshold=15 --no-pager "$work/frond.service" >"$work/security" 2>&1 ||
    fail "with MQTT it may do too much: $(tail -n 1 "$work/security")"
sed -n 's/^.*\(Overall exposure level.*\)/with MQTT: \1/p' "$work/security"

# Files for systemd and udev are read without a complaint.
if command -v systemd-sysusers >/dev/null; then
    mkdir -p "$work/system/etc" "$work/system/usr"
    cp -r "$work/root/lib" "$work/system/usr/"
    systemd-sysusers --root="$work/system" frond.conf >"$work/log" 2>&1 || fail "sysusers: $(cat "$work/log")"
    grep -q '^frond:.*:/usr/sbin/nologin$' "$work/system/etc/passwd" || fail "no user"
    for group in video render input gpio; do
        grep -q "^$group:.*frond" "$work/system/etc/group" || fail "frond is not in $group"
    done
fi
verdict

# shellcheck shell=bash
# Roots of Debian to build and test in. Sourced by arm64, package, root and trixie.

say() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
}

skip() {
    say "SKIPPED: $*"
    exit 77
}

# The archive that this machine itself uses, so that no mirror is named here.
archive() {
    awk '/^URIs:/ { print $2; exit }' /etc/apt/sources.list.d/debian.sources 2>/dev/null ||
        awk '$1 == "deb" { print $2; exit }' /etc/apt/sources.list 2>/dev/null
}

# Skips where roots cannot be entered.
may_enter() {
    ((EUID == 0)) || skip "only root can enter a root of Debian"
    unshare --mount true 2>/dev/null || skip "this machine forbids mounts"
}

# One at a time works in a cache of roots, until its script ends.
lock_cache() { # lock_cache FOLDER SECONDS
    mkdir -p "$1"
    exec {roots_lock}>"$1/lock"
    flock -w "$2" "$roots_lock" || skip "another one has held $1/lock for $2 s"
}

# A root, or nothing at all. What mmdebstrap says is left beside it, in the file `log`.
make_root() { # make_root ROOT SUITE SECONDS [OPTIONS OF MMDEBSTRAP]...
    local root=$1 suite=$2 seconds=$3 from new log=${1%/*}/log
    shift 3
    [[ ! -d $root ]] || return 0
    command -v mmdebstrap >/dev/null || skip "no mmdebstrap: apt-get install mmdebstrap"
    from=$(archive)
    [[ $from ]] || skip "no Debian archive in the sources of apt"
    mkdir -p "${root%/*}"
    new=$(mktemp -d "${root%/*}/new.XXXXXX")
    timeout "$seconds" mmdebstrap --quiet "$@" "$suite" "$new" "$from" 2>"$log" || {
        rm -rf "$new"
        skip "the root ${root##*/} cannot be made: $(tail -n 1 "$log")"
    }
    chmod 755 "$new"
    mv "$new" "$root"
}

# What a system has in its folders beside files, and the names of its network, mounted in ROOT; in a mount name space of its
# own, inside its own process name space.
furnish() { # furnish ROOT
    local device
    mount -t proc proc "$1/proc"
    mount --bind "$1/proc/sys" "$1/proc/sys" # packages set what the kernel of this machine does, as they are installed
    mount -o remount,bind,ro "$1/proc/sys"
    mount -t sysfs -o ro sysfs "$1/sys"
    mount -t tmpfs -o mode=755 tmpfs "$1/dev"
    mount -t tmpfs -o mode=755 tmpfs "$1/run"
    mount -t tmpfs -o mode=1777 tmpfs "$1/tmp"
    for device in null zero full random urandom tty kvm; do
        [[ -e /dev/$device ]] || continue
        touch "$1/dev/$device"
        mount --bind "/dev/$device" "$1/dev/$device"
    done
    mkdir "$1/dev/pts"
    mkdir -m 1777 "$1/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts"
    ln -s pts/ptmx "$1/dev/ptmx"
    ln -s /proc/self/fd "$1/dev/fd"
    ln -s /proc/self/fd/0 "$1/dev/stdin"
    ln -s /proc/self/fd/1 "$1/dev/stdout"
    ln -s /proc/self/fd/2 "$1/dev/stderr"
    cp -L /etc/resolv.conf "$1/etc/resolv.conf" 2>/dev/null || true
    [[ -e $1/etc/hosts ]] || printf '127.0.0.1 localhost\n::1 localhost\n' >"$1/etc/hosts"
}

# FOLDER of this machine seen at PLACE (absolute) of the root; for reading only where MODE is ro.
bind_folder() { # bind_folder ROOT FOLDER:PLACE[:MODE]
    local folder place mode
    IFS=: read -r folder place mode <<<"$2"
    mkdir -p "$1$place"
    mount --bind "$folder" "$1$place"
    [[ $mode != ro ]] || mount -o remount,bind,ro "$1$place"
}

# A copy of ROOT in FOLDER/root that vanishes with the name space.
overlay() { # overlay ROOT FOLDER
    mount -t tmpfs tmpfs "$2"
    mkdir "$2/upper" "$2/work" "$2/root"
    mount -t overlay overlay -o "lowerdir=$1,upperdir=$2/upper,workdir=$2/work" "$2/root"
}

# Nothing of this machine's environment is known in the root. VARIABLE=VALUE are set there.
in_root() { # in_root ROOT SECONDS [--copy FOLDER] [--bind FOLDER:PLACE[:MODE]]... [VARIABLE=VALUE]... SCRIPT
    # shellcheck disable=SC2016 # the inner shell's
    timeout "$2" unshare --mount --pid --fork --kill-child bash -euc "$(declare -f furnish bind_folder overlay)"'
        root=$1
        shift 2
        if [[ $1 == --copy ]]; then
            overlay "$root" "$2"
            root=$2/root
            shift 2
        else
            mount --bind "$root" "$root"
        fi
        furnish "$root"
        while [[ $1 == --bind ]]; do
            bind_folder "$root" "$2"
            shift 2
        done
        # A mount in the place of / is no chroot to the kernel, which forbids name spaces of users in those.
        cd "$root"
        mount --move . /
        exec chroot . /usr/bin/env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
            "${@:1:$# - 1}" bash -euc "${@: -1}"
    ' - "$@"
}

# shellcheck shell=bash
# The packages that Frond is built with. Sourced by app/run and tests/run.

say() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
}

# Prints the packages of the lists given that are not installed. Asks dpkg only: takes no time and no network.
missing_packages() {
    local wanted installed
    wanted=$(sed 's/#.*//' "$@" | tr -s '[:space:]' '\n' | sed '/^$/d' | sort -u)
    # dpkg-query fails when it does not know one of them, and still prints the others.
    # shellcheck disable=SC2086 # one word a package
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
        sed -n 's/^installed //p' | sort -u) || true
    comm -23 <(printf '%s\n' "$wanted") <(printf '%s\n' "$installed")
}

# apt-get as root, asking nothing. Waits for another apt that is at work.
apt_get() {
    local become=()
    if ((EUID != 0)); then
        become=(sudo)
        [[ -t 0 ]] || become+=(-n)
    fi
    "${become[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -y -o DPkg::Lock::Timeout=120 -o Dpkg::Use-Pty=0 "$@" >&2
}

# Prints those of the packages given that apt could not install.
without_candidate() {
    local package policy
    for package in "$@"; do
        policy=$(apt-cache policy "$package" 2>/dev/null) || true
        if ! grep -q '^  Candidate: [^(]' <<<"$policy"; then
            printf '%s\n' "$package"
        fi
    done
}

# Installs what is missing of the lists given. Stops the script when that cannot be done, naming the packages.
install_missing() {
    local missing unknown
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "this is not Debian: install what stands in $* by other means and say --no-install"
        exit 1
    fi
    mapfile -t missing < <(missing_packages "$@")
    if ((${#missing[@]} == 0)); then
        return
    fi
    say "installing ${missing[*]}"
    if ((EUID != 0)) && ! command -v sudo >/dev/null; then
        say "neither root nor sudo: as root, apt-get install ${missing[*]}"
        exit 1
    fi
    mapfile -t unknown < <(without_candidate "${missing[@]}")
    # Lists that know every package may still be stale: then the first try fails, and they are fetched for a second.
    if ((${#unknown[@]} > 0)) || ! apt_get install --no-install-recommends "${missing[@]}"; then
        if ! apt_get -o APT::Update::Error-Mode=any update; then
            say "the package lists cannot be fetched; is there a network? Missing: ${missing[*]}"
            exit 1
        fi
        mapfile -t unknown < <(without_candidate "${missing[@]}")
        if ((${#unknown[@]} > 0)); then
            say "this system offers no ${unknown[*]}: Frond is built on Debian 12"
            exit 1
        fi
        apt_get install --no-install-recommends "${missing[@]}" || {
            say "cannot install ${missing[*]}: see what apt-get says above"
            exit 1
        }
    fi
}

# Says what is missing of the lists given and goes on: for --no-install.
name_missing() {
    local missing=()
    if command -v dpkg-query >/dev/null; then
        mapfile -t missing < <(missing_packages "$@")
    fi
    if ((${#missing[@]} > 0)); then
        say "not installed, and left so: ${missing[*]}"
    fi
}

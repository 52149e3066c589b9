# shellcheck shell=bash
# Sourced by the checks whose answer is that of one version of LLVM alone.

# Ends with 77, saying why, unless PROGRAM is of VERSION.
only_of() { # only_of PROGRAM VERSION
    local found
    found=$("$1" --version | sed -n 's/.* version \([0-9]*\)\..*/\1/p')
    if [[ $found != "$2" ]]; then
        printf 'SKIPPED: what %s %s says is asked; here is %s\n' "$1" "$2" "${found:-none}" >&2
        exit 77
    fi
}

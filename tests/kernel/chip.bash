# shellcheck shell=bash
# A chip of GPIO lines of the kernel's own (gpio-sim), labelled "board", for scenarios: 8 lines, the first of them named.
config=/sys/kernel/config/gpio-sim/board

plug_chip() { # sets `attributes`, of which each line has a folder
    local line=0
    mkdir "$config" "$config/bank0" "$config/bank0/line0"
    echo 8 >"$config/bank0/num_lines"
    echo board >"$config/bank0/label"
    echo BTN_OK >"$config/bank0/line0/name"
    echo 1 >"$config/live"
    attributes=/sys/devices/platform/$(<"$config/dev_name")/$(<"$config/bank0/chip_name")/sim_gpio
    for ((line = 0; line < 8; line++)); do
        [[ -w $attributes$line/pull ]] || printf 'no %s\n' "$attributes$line/pull"
    done
}
unplug_chip() {
    echo 0 >"$config/live"
    rmdir "$config/bank0/line0" "$config/bank0" "$config"
}
pull() { # pull LINE up|down
    echo "pull-$2" >"$attributes$1/pull"
}

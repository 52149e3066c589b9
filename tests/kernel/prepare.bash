# shellcheck shell=bash
# Makes the parts of the virtual machine once: Debian's kernel, the modules that Debian does not build, and what the guest
# needs beside this machine's own root. Sourced by `machine`.
#
# A set of parts is a folder of the cache, made aside and renamed into place when it is whole:
#   KERNEL-HASH/  vmlinux, busybox, base (initramfs with busybox and modules), probe (initramfs that only says it is up),
#                 extra/ (udev, for roots that have none), version
# KERNEL is the package's version, HASH that of this file, so that a set is made anew when either changes.

# Modules that the guest loads; what they need in turn is found from the modules themselves.
modules_wanted=(virtio_pci 9p 9pnet_virtio overlay virtio_console configfs evdev uinput uhid hid_generic hid_multitouch
    usbhid xhci_pci virtio_gpu bochs virtio_input irq_sim gpio_sim vkms)
modules_kept=(vkms) # not loaded at boot: a command does `insmod /machine/modules/vkms.ko`
guest_packages=(udev kmod libkmod2)

# Set by `machine`: `here`, this folder; `cache`; `new`, the set that is being made.
: "${here:?}" "${cache:?}"

prepare_hash() {
    sha256sum "$here/prepare.bash" | cut -c 1-12
}

# Prints the folder of the newest set that this file has made; fails when there is none.
prepared() {
    local newest
    newest=$(find "$cache" -mindepth 2 -maxdepth 2 -path "*-$(prepare_hash)/version" -printf '%T@ %h\n' 2>/dev/null |
        sort -rn | head -n 1)
    [[ $newest ]] && printf '%s\n' "${newest#* }"
}

# Why no machine can be made here at all; silent when one can.
prepare_obstacle() {
    local tool
    [[ $(uname -m) == x86_64 ]] || printf 'this machine is %s: the kernel and QEMU are for x86_64\n' "$(uname -m)"
    for tool in apt-get:apt dpkg-deb:dpkg gcc:gcc make:make objcopy:binutils python3:python3 xz:xz-utils zstd:zstd \
        qemu-system-x86_64:qemu-system-x86; do
        command -v "${tool%:*}" >/dev/null || printf 'no %s: apt-get install %s\n' "${tool%:*}" "${tool#*:}"
    done
}

# ---- packages, fetched as files: nothing is installed

apt=(-q -o APT::Sandbox::User=root -o Acquire::Retries=1 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20)

# Lists of our own, where the machine's are missing or so old that the archive has dropped what they name. Same sources.
own_lists() {
    say "fetching package lists"
    mkdir -p "$new/lists/partial"
    apt+=(-o "Dir::State::Lists=$new/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=)
    # Ends with 0 even when nothing could be fetched: whether it helped is seen from what is known then.
    timeout 180 apt-get "${apt[@]}" update >>"$new/log" 2>&1 || true
}
kernel_package() { # prints linux-image-6.1.0-N-amd64 and its version
    local image
    image=$(apt-cache "${apt[@]}" depends linux-image-amd64 2>/dev/null | awk '/Depends: linux-image/ { print $2; exit }')
    [[ $image ]] || return 1
    printf '%s %s\n' "$image" "$(apt-cache "${apt[@]}" show --no-all-versions "$image" | awk '/^Version:/ { print $2; exit }')"
}
download() {
    (cd "$new/packages" && timeout 900 apt-get "${apt[@]}" download "$@" >>"$new/log" 2>&1)
}
unpack() { # unpack FOLDER PACKAGE...
    local folder=$1 package
    shift
    mkdir -p "$folder"
    for package in "$@"; do
        dpkg-deb -x "$new"/packages/"${package}"_*.deb "$folder"
    done
}

# Sets `image`, `version`, `release` (6.1.0-N-amd64), `kbuild` and `series`, and `packages` to all that is fetched.
choose_kernel() {
    local found
    found=$(kernel_package) || return 1
    read -r image version <<<"$found"
    release=${image#linux-image-}
    series=${version%%.*}.$(cut -d . -f 2 <<<"$version")
    kbuild=$(apt-cache "${apt[@]}" depends "linux-headers-$release" | awk '/Depends: linux-kbuild/ { print $2; exit }')
    packages=("$image" "linux-headers-$release" "linux-headers-${release%-amd64}-common" "$kbuild"
        "linux-source-$series" busybox-static "${guest_packages[@]}")
}
# Fetches `packages` into the set being made, or sets `why` and fails.
fetch() {
    mkdir -p "$new/packages"
    # One small package first: without a network this ends at once, or after twenty seconds.
    if choose_kernel && download busybox-static && download "${packages[@]}"; then
        return
    fi
    own_lists
    if ! choose_kernel; then
        why="apt knows no linux-image-amd64; is there a network? $(grep -m 1 '^[WE]:' "$new/log" || true)"
        return 1
    fi
    if ! download "${packages[@]}"; then
        why="the kernel's packages cannot be fetched: $(tail -n 1 "$new/log")"
        return 1
    fi
}

# ---- the kernel and its modules

# An uncompressed kernel starts by QEMU's PVH entry at once; unpacking it under emulation costs three seconds a boot.
extract_kernel() { # extract_kernel VMLINUZ VMLINUX
    local sectors at length tool
    # Where it lies, as the header says (the kernel's Documentation/arch/x86/boot.rst: setup_sects, payload_offset and
    # payload_length). The last four bytes tell its size.
    sectors=$(od -An -tu1 -j 497 -N 1 "$1")
    read -r at length < <(od -An -tu4 -j 584 -N 8 "$1")
    at=$((at + (sectors + 1) * 512))
    for tool in xz zstd gzip; do
        tail -c "+$((at + 1))" "$1" | head -c "$((length - 4))" | "$tool" -dc >"$2" 2>/dev/null || true
        [[ $(head -c 4 "$2" | tr -d '\177') == ELF ]] && return
    done
    fail "no kernel found in $1"
}

# Debian builds no gpio-sim, irq_sim or vkms: they are built as modules, from Debian's source of the same kernel.
build_modules() {
    local headers=$1 build=$2
    mkdir -p "$build" "$new/source"
    dpkg-deb --fsys-tarfile "$new"/packages/linux-source-"$series"_*.deb |
        tar -xOf - "./usr/src/linux-source-$series.tar.xz" | xz -dc -T0 |
        tar -xf - -C "$new/source" --strip-components=1 --wildcards '*/drivers/gpio/gpio-sim.c' '*/drivers/gpio/gpiolib.h' \
            '*/kernel/irq/irq_sim.c' '*/drivers/gpu/drm/vkms/*'
    cp "$new"/source/drivers/gpio/gpio{-sim.c,lib.h} "$new/source/kernel/irq/irq_sim.c" "$build"
    cp -r "$new/source/drivers/gpu/drm/vkms" "$build"
    # irq_to_desc() is not exported to modules; generic_handle_irq() is, and does the same here.
    sed -i 's/handle_simple_irq(irq_to_desc(\([a-z]*\)))/generic_handle_irq(\1)/' "$build/irq_sim.c"
    printf '\n#include <linux/module.h>\nMODULE_LICENSE("GPL");\n' >>"$build/irq_sim.c"
    # shellcheck disable=SC2016 # make's variable
    sed -i 's/obj-$(CONFIG_DRM_VKMS)/obj-m/' "$build/vkms/Makefile"
    printf 'obj-m := gpio-sim.o irq_sim.o vkms/\n' >"$build/Kbuild"
    sed -i "s#/usr/src/#$headers/usr/src/#g" "$headers/usr/src/linux-headers-$release/Makefile"
    make -s -j 2 -C "$headers/usr/src/linux-headers-$release" "M=$build" CONFIG_DEBUG_INFO_BTF_MODULES= modules \
        >"$new/modules.log" 2>&1 || fail "the modules do not build: $(grep -m 3 -E 'error|not found' "$new/modules.log")"
}

# Prints the files of the modules named, each after those it depends on.
ordered_modules() { # ordered_modules FOLDER...
    local -A file=() seen=()
    local name module
    while IFS= read -r module; do
        name=${module##*/}
        name=${name%.ko}
        file[${name//-/_}]=$module
    done < <(find "$@" -name '*.ko')
    while IFS= read -r module; do # parts of the kernel itself
        name=${module##*/}
        name=${name%.ko}
        seen[${name//-/_}]=1
    done < <(find "$@" -name modules.builtin -exec cat {} +)
    visit() {
        local wanted=${1//-/_} needs need
        [[ ! ${seen[$wanted]:-} ]] || return 0
        seen[$wanted]=1
        [[ ${file[$wanted]:-} ]] || fail "this kernel has no module $wanted"
        needs=$(tr '\0' '\n' <"${file[$wanted]}" | grep -a -m 1 '^depends=' || true)
        needs=${needs#depends=}
        for need in ${needs//,/ }; do
            visit "$need"
        done
        printf '%s\n' "${file[$wanted]}"
    }
    for module in "${modules_wanted[@]}"; do
        visit "$module"
    done
}

# ---- the initramfs

pack() { # pack FOLDER FILE
    (cd "$1" && find . | "$new/busybox" cpio -o -H newc 2>/dev/null | gzip -1) >"$2"
}
pack_base() {
    local base=$new/base.d file kept
    mkdir -p "$base/bin" "$base/modules"
    cp "$new/busybox" "$base/bin/"
    ordered_modules "$new/kernel" "$new/build" >"$new/modules.list"
    while IFS= read -r file; do
        objcopy --strip-debug "$file" "$base/modules/${file##*/}"
        kept=" ${modules_kept[*]/%/.ko} "
        [[ $kept == *" ${file##*/} "* ]] || printf '%s\n' "${file##*/}"
    done <"$new/modules.list" >"$base/modules/list"
    pack "$base" "$new/base"
}
pack_probe() {
    mkdir -p "$new/probe.d/bin"
    cp "$new/busybox" "$new/probe.d/bin/"
    printf '#!/bin/busybox sh\necho MACHINE-UP >/dev/console\n/bin/busybox poweroff -f\n' >"$new/probe.d/init"
    chmod +x "$new/probe.d/init"
    pack "$new/probe.d" "$new/probe"
}

# Whether KVM really runs a kernel here: /dev/kvm may be there and be of no use.
probe_acceleration() {
    local answer=tcg
    if [[ -w /dev/kvm ]] && timeout 15 qemu-system-x86_64 -accel kvm -cpu host -m 256 -nodefaults -display none -no-reboot \
        -serial stdio -kernel "$new/vmlinux" -initrd "$new/probe" -append "console=ttyS0 quiet panic=-1" \
        </dev/null 2>/dev/null | grep -q MACHINE-UP; then
        answer=kvm
    fi
    printf '%s\n' "$answer" >"$new/acceleration"
}

make_parts() {
    local folder
    unpack "$new/kernel" "$image"
    find "$new/kernel" -name '*.ko.xz' -exec xz -d {} + # newer kernels than 6.1 pack their modules
    unpack "$new/headers" "linux-headers-$release" "linux-headers-${release%-amd64}-common" "$kbuild"
    unpack "$new/bin" busybox-static
    find "$new/bin" -type f -name busybox -exec mv {} "$new/busybox" \;
    extract_kernel "$new/kernel/boot/vmlinuz-$release" "$new/vmlinux"
    build_modules "$new/headers" "$new/build"
    pack_base
    pack_probe
    unpack "$new/extra" "${guest_packages[@]}"
    # Folders of / are links into /usr on the root that this is laid over.
    for folder in bin sbin lib; do
        if [[ -d $new/extra/$folder ]]; then
            mkdir -p "$new/extra/usr/$folder"
            cp -a "$new/extra/$folder/." "$new/extra/usr/$folder/"
            rm -rf "${new:?}/extra/$folder"
        fi
    done
    probe_acceleration
    printf '%s\n' "$version" >"$new/version"
    rm -rf "${new:?}"/{packages,lists,kernel,headers,source,build,bin,base.d,probe.d,modules.list}
}

# Makes a set unless there is one of the kernel that apt offers now. Where that cannot be fetched, an older one will do.
prepare() {
    local obstacle name image version release series packages found have why
    obstacle=$(prepare_obstacle)
    [[ ! $obstacle ]] || skip "${obstacle//$'\n'/; }"
    mkdir -p "$cache"
    exec {lock}>"$cache/lock"
    flock -w 900 "$lock" || fail "another preparation has held $cache/lock for a quarter of an hour"
    found=$(kernel_package) || found=
    have=$(prepared) || have=
    if [[ $have && (! $found || $(<"$have/version") == "${found#* }") ]]; then
        return
    fi
    say "preparing in $cache: fetching Debian's kernel"
    rm -rf "$cache"/new.* # of a run that was killed: under the lock nobody is at work there
    new=$(mktemp -d "$cache/new.XXXXXX")
    if ! fetch; then
        [[ $have ]] || skip "$why"
        say "$why"
        say "going on with ${have##*/}"
        return
    fi
    say "building the modules of kernel $version"
    make_parts
    name=$version-$(prepare_hash)
    rm -rf "${cache:?}/$name"
    mv "$new" "$cache/$name"
    new=
    # Sets of other kernels, and of this file as it was: other worktrees may still be at work with theirs.
    find "$cache" -mindepth 1 -maxdepth 1 -type d ! -name "$name" -mtime +14 -exec rm -rf {} +
    say "prepared: kernel $version, $(<"$cache/$name/acceleration"), $(du -sh "$cache/$name" | cut -f 1) in $cache/$name"
}

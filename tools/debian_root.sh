#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Roots of Debian made by debootstrap, shared by newest_freecad.sh and first_run.sh: the mirror, what a root needs of this
# machine to reach it, and how a command runs inside. To be sourced.

# ---------------------------------------------------------------------------------------------------- the mirror

mirror_of_sources() {
    # deb822 files: the first http(s) address of the first stanza that is enabled, of type deb and no security suite.
    for file in /etc/apt/sources.list.d/*.sources; do
        [ -f "$file" ] || continue
        grep -v '^#' "$file" | awk 'BEGIN { RS = ""; FS = "\n" }
            {
                split("", value)
                for (i = 1; i <= NF; i++) {
                    colon = index($i, ":")
                    if (colon) value[tolower(substr($i, 1, colon - 1))] = substr($i, colon + 1)
                }
                if (tolower(value["enabled"]) ~ /no/ || value["suites"] ~ /security/) next
                if ((" " value["types"] " ") !~ / deb /) next
                n = split(value["uris"], uri, " ")
                for (i = 1; i <= n; i++) if (uri[i] ~ /^https?:/) { print uri[i]; exit }
            }'
    done
    # One-line files: deb [options] ADDRESS SUITE ...
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -f "$file" ] || continue
        sed -n 's/^deb[[:space:]]\{1,\}\(\[[^]]*\][[:space:]]*\)\{0,1\}//p' "$file" |
            awk '$1 ~ /^https?:/ && $2 !~ /security/ { print $1; exit }'
    done
}

mirror() {
    if [ -n "${TRABECULA_MIRROR:-}" ]; then
        printf '%s\n' "$TRABECULA_MIRROR"
        return
    fi
    found=
    # Another distribution's mirror (Ubuntu's, say) holds no forky.
    if grep -q '^ID=debian' /etc/os-release; then
        found=$(mirror_of_sources | head -n 1)
    fi
    printf '%s\n' "${found:-http://deb.debian.org/debian}"
}

copy_network_settings() {
    # Name servers, apt's settings and passwords, the certificates they name, and certificates added to this machine.
    target=$1
    mkdir -p "$target/etc/apt/apt.conf.d" "$target/etc/apt/auth.conf.d" "$target/usr/local/share/ca-certificates"
    cp -L /etc/resolv.conf "$target/etc/resolv.conf"
    for file in /etc/apt/apt.conf /etc/apt/auth.conf; do
        if [ -f "$file" ]; then cp -L "$file" "$target$file"; fi
    done
    for folder in /etc/apt/apt.conf.d /etc/apt/auth.conf.d /usr/local/share/ca-certificates; do
        if [ -d "$folder" ]; then cp -RL "$folder/." "$target$folder/"; fi
    done
    # Files that the settings refer to: client certificates, keys, a script that finds the proxy.
    apt-config dump | sed -n 's/^Acquire::[^ ]* "\(\/[^"]*\)";$/\1/p' | while read -r file; do
        if [ -f "$file" ] && [ ! -e "$target$file" ]; then
            mkdir -p "$target$(dirname "$file")"
            cp -L "$file" "$target$file"
        fi
    done
}

mount_basics() {
    mount --rbind /proc "$1/proc"
    mount --rbind /dev "$1/dev"
}

umount_all() {
    # The namespace would drop them anyway, but rm and mv must not meet them.
    for folder in proc dev; do
        if mountpoint -q "$1/$folder"; then umount -R -l "$1/$folder"; fi
    done
}

enter() {
    # enter ROOT FOLDER CMD...: the machine's own Python, display and library paths mean nothing inside.
    where=$1
    folder=$2
    shift 2
    env -u DISPLAY -u WAYLAND_DISPLAY -u XAUTHORITY -u LD_LIBRARY_PATH -u PYTHONPATH -u PYTHONHOME -u VIRTUAL_ENV \
        -u PYENV_ROOT -u PIP_FIND_LINKS -u FREECAD_USER_HOME -u FREECADCMD -u LC_ALL -u XDG_RUNTIME_DIR -u TMPDIR \
        HOME=/root USER=root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        QTWEBENGINE_DISABLE_SANDBOX=1 chroot "$where" /bin/sh -c 'cd "$1" && shift && exec "$@"' sh "$folder" "$@"
}

need_debootstrap() {
    command -v debootstrap >/dev/null || {
        echo "installing debootstrap (apt)" >&2
        apt-get update -q >&2 && apt-get install -y -q --no-install-recommends debootstrap >&2
    }
}

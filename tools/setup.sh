#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Installs what Trabecula needs on Debian, if it is missing, and says what it installs:
#   by apt (as root, or with sudo): FreeCAD, a display without a screen (Xvfb), numpy, scipy, pytest, pip, matplotlib (plots), openpyxl (workbooks), Pillow (images);
#   by pip, into FreeCAD's own folder for additional packages: manifold3d, the library of mesh Booleans.
# Does nothing, within a second or two, when nothing is missing.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
packages="freecad xvfb xauth libgl1-mesa-dri libxkbcommon-x11-0 python3-numpy python3-scipy python3-pytest python3-pip"
packages="$packages python3-matplotlib python3-openpyxl python3-pil"
# Debian's own Python: the one that apt's numpy and FreeCAD belong to, whatever else is first on PATH.
python=/usr/bin/python3
manifold=manifold3d==3.5.4

say() { printf '%s\n' "setup: $*"; }
die() { printf '%s\n' "setup: $*" >&2; exit 1; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        printf '%s\n' "needs root, or sudo" >&2
        return 1
    fi
}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'exit 130' INT TERM HUP

is_installed() {
    case $(dpkg-query -W -f='${Status}' "$1" 2>/dev/null || true) in
        *" installed") return 0 ;;
        *) return 1 ;;
    esac
}

install_missing() {
    missing=
    for package in "$@"; do
        is_installed "$package" || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    say "installing by apt (FreeCAD takes a few minutes):$missing"
    # Thousands of lines that nobody reads, unless it fails.
    # shellcheck disable=SC2086  # the packages are words
    {
        as_root apt-get update -q </dev/null &&
            as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
                -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 $missing </dev/null
    } >"$folder/log" 2>&1 || {
        tail -n 30 "$folder/log" >&2
        die "apt could not install:$missing"
    }
}

if command -v dpkg-query >/dev/null; then
    # shellcheck disable=SC2086
    install_missing $packages
    # Mouse and keys for the tests of the window, from the Qt that this FreeCAD was built with.
    for pyside in python3-pyside2 python3-pyside6; do
        if is_installed "$pyside.qtcore"; then install_missing "$pyside.qttest"; fi
    done
else
    for command in freecadcmd freecad xvfb-run; do
        command -v "$command" >/dev/null || die "$command is not on PATH, and this is no Debian: please install it"
    done
fi

TRABECULA_FACTS=$folder/facts.json freecadcmd "$here/freecad_facts.py" >"$folder/log" 2>&1 </dev/null || {
    cat "$folder/log" >&2
    die "freecadcmd does not run"
}
fact() {
    "$python" -c 'import json, sys
facts = json.load(open(sys.argv[1]))
print(facts[sys.argv[2]] if sys.argv[2] in facts else facts["modules"][sys.argv[2]] or "none")' \
        "$folder/facts.json" "$1"
}
if [ "$(fact manifold3d)" = none ]; then
    target=$(fact packages)
    say "installing by pip into $target: $manifold"
    mkdir -p "$target"
    # Without its dependency (numpy): a second, newer numpy beside apt's would not go with apt's scipy.
    "$python" -m pip install --quiet --disable-pip-version-check --no-input --no-deps --only-binary :all: \
        --root-user-action ignore --target "$target" "$manifold" </dev/null
fi
say "FreeCAD $(fact freecad), Python $(fact python), numpy $(fact numpy), scipy $(fact scipy) and manifold3d are here"

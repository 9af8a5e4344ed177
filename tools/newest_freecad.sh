#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# The newest FreeCAD of Debian (testing, "forky") in a root of its own, beside whatever FreeCAD this machine has.
#
#   sh tools/newest_freecad.sh build          make the root if it is not there (3 GB, 3 to 5 minutes)
#   sh tools/newest_freecad.sh run CMD...     run a command in it, from the same folder, with this checkout at its path
#   sh tools/newest_freecad.sh where          print the folder of the root
#   sh tools/newest_freecad.sh remove         throw the root away
#
# The root stays in ${TRABECULA_CACHE:-~/.cache/trabecula}/forky. Everything that is mounted is mounted in a private
# mount namespace (unshare), which the kernel drops with its last process: nothing is left mounted after a failure, an
# interrupt or a kill, and any number of `run`s may go on at once.
#
# Environment: TRABECULA_CACHE, TRABECULA_MIRROR (a Debian mirror; default: this machine's own), TRABECULA_DATA (a folder
# of large test files, seen read-only inside; default: ../shared/data beside the checkout, if it is there).
set -eu

suite=forky
packages="freecad xvfb xauth libgl1-mesa-dri libxkbcommon-x11-0 python3-numpy python3-scipy python3-pip python3-pytest make git"
here=$(cd "$(dirname "$0")" && pwd -P)
checkout=$(dirname "$here")
cache=${TRABECULA_CACHE:-$HOME/.cache/trabecula}
root=$cache/$suite
stamp=$root/.trabecula-complete
# The stamp holds what the root was made of, so that another list of packages makes another root.
recipe="1 $suite $packages"

. "$here/debian_root.sh"

say() { printf '%s\n' "newest_freecad: $*" >&2; }
die() { say "$*"; exit 1; }

usage() { sed -n '3,17s/^#\{1,\} \{0,1\}//p' "$0"; }

as_root() {
    # Only root may chroot and mount; sudo keeps the few variables that matter.
    if [ "$(id -u)" -eq 0 ]; then
        exec "$@"
    fi
    command -v sudo >/dev/null || die "needs root, or sudo, to make and enter the root $root"
    exec sudo TRABECULA_CACHE="$cache" TRABECULA_MIRROR="${TRABECULA_MIRROR:-}" TRABECULA_DATA="${TRABECULA_DATA:-}" \
        TRABECULA_TIMEOUT="${TRABECULA_TIMEOUT:-}" CI="${CI:-}" "$@"
}

is_complete() { [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$recipe" ]; }

# ---------------------------------------------------------------------------------------------------- making the root

make_root() {
    # Runs as root in a mount namespace of its own, under the lock.
    if is_complete; then return; fi
    need_debootstrap
    address=$(mirror)
    say "making $root: Debian $suite from $address (3 GB, 3 to 5 minutes)"
    say "packages: $packages"
    part=$root.part
    rm -rf --one-file-system "$part" "$root"
    mkdir -p "$part"
    trap 'say "failed; the half-made root is thrown away"; umount_all "$part"; rm -rf --one-file-system "$part"' EXIT
    trap 'exit 130' INT TERM HUP
    # Debian 12's debootstrap has no script for forky; sid's is the same.
    debootstrap --variant=minbase --include=ca-certificates "$suite" "$part" "$address" \
        /usr/share/debootstrap/scripts/sid >"$cache/$suite.log" 2>&1 || { tail -n 20 "$cache/$suite.log" >&2; exit 1; }
    printf 'deb %s %s main\n' "$address" "$suite" >"$part/etc/apt/sources.list"
    rm -f "$part"/etc/apt/sources.list.d/*.sources
    copy_network_settings "$part"
    # No daemons are started, manuals are left out, and nothing is synced file by file: half the time and space.
    printf '#!/bin/sh\nexit 101\n' >"$part/usr/sbin/policy-rc.d"
    chmod 755 "$part/usr/sbin/policy-rc.d"
    printf '%s\n' force-unsafe-io 'path-exclude /usr/share/doc/*' 'path-exclude /usr/share/man/*' \
        'path-exclude /usr/share/locale/*' >"$part/etc/dpkg/dpkg.cfg.d/trabecula"
    mount_basics "$part"
    # shellcheck disable=SC2086  # the packages are words
    enter "$part" / sh -c 'export DEBIAN_FRONTEND=noninteractive
        update-ca-certificates && apt-get update -q && apt-get install -y -q --no-install-recommends "$@" && apt-get clean
        ' sh $packages >>"$cache/$suite.log" 2>&1 || { tail -n 20 "$cache/$suite.log" >&2; exit 1; }
    umount_all "$part"
    trap - EXIT INT TERM HUP
    printf '%s' "$recipe" >"$part/.trabecula-complete"
    mv "$part" "$root"
    say "made $root"
}

# ---------------------------------------------------------------------------------------------------- being inside

bind() {
    # bind FOLDER [ro]: the machine's folder at the same path inside.
    mkdir -p "$root$1"
    mount --rbind "$1" "$root$1"
    if [ "${2:-}" = ro ]; then mount -o remount,bind,ro "$root$1"; fi
}

run_inside() {
    # Runs as root in a mount namespace of its own.
    folder=$1
    shift
    mount_basics "$root"
    # The machine's /tmp, so that servers for displays see each other's locks, and a checkout in /tmp is there.
    bind /tmp
    bind "$checkout"
    data=${TRABECULA_DATA:-$(dirname "$checkout")/shared/data}
    if [ -d "$data" ]; then
        data=$(cd "$data" && pwd -P)
        export TRABECULA_DATA="$data"
        bind "$data" ro
    fi
    cmp -s /etc/resolv.conf "$root/etc/resolv.conf" || cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    if [ ! -d "$root$folder" ]; then folder=$checkout; fi
    status=0
    enter "$root" "$folder" "$@" || status=$?
    # What a user's tests wrote into the checkout is the user's.
    if [ -n "${SUDO_UID:-}" ] && [ -d "$checkout/build" ]; then chown -R "$SUDO_UID" "$checkout/build" || true; fi
    exit "$status"
}

build() {
    if is_complete; then return; fi
    mkdir -p "$cache"
    (as_root flock -o "$cache/$suite.lock" unshare --mount --propagation private sh "$here/newest_freecad.sh" _make)
}

case ${1:-} in
    build) build ;;
    run)
        shift
        [ $# -gt 0 ] || die "run: which command?"
        build
        as_root unshare --mount --propagation private sh "$here/newest_freecad.sh" _run "$(pwd -P)" "$@"
        ;;
    where) printf '%s\n' "$root" ;;
    remove) as_root rm -rf --one-file-system "$root" "$root.part" ;;
    _make) make_root ;;
    _run)
        shift
        run_inside "$@"
        ;;
    *)
        usage
        [ "${1:-}" = --help ] || exit 2
        ;;
esac

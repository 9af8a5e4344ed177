#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# How long the README's two commands take from a bare machine: a Debian 12 with nothing but make and git, made by debootstrap
# for this run and thrown away after it; a fresh clone of what is committed here.
#
#   sh tools/first_run.sh          prints the times of the set-up (which both commands do first) and of the demo
#
# Needs root or sudo, 4 GB in ${TRABECULA_CACHE:-~/.cache/trabecula}, 5 to 15 minutes. Everything is mounted in a private
# mount namespace. Environment: TRABECULA_CACHE, TRABECULA_MIRROR.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
checkout=$(dirname "$here")
cache=${TRABECULA_CACHE:-$HOME/.cache/trabecula}
root=$cache/first-run

. "$here/debian_root.sh"

say() { printf '%s\n' "first_run: $*"; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then exec "$@"; fi
    exec sudo TRABECULA_CACHE="$cache" TRABECULA_MIRROR="${TRABECULA_MIRROR:-}" "$@"
}

timed() {
    # timed WORDS CMD...: runs a command in the root and says how long it took; its output goes to a log.
    words=$1
    shift
    begun=$(date +%s)
    enter "$root" /root/trabecula "$@" >"$root/log" 2>&1 || { tail -n 40 "$root/log"; say "$words failed"; exit 1; }
    say "$words: $(($(date +%s) - begun)) s"
}

measure() {
    # Runs as root in a mount namespace of its own.
    need_debootstrap
    rm -rf --one-file-system "$root"
    mkdir -p "$root"
    trap 'umount_all "$root"; rm -rf --one-file-system "$root"' EXIT
    trap 'exit 130' INT TERM HUP
    address=$(mirror)
    debootstrap --variant=minbase --include=ca-certificates,make,git bookworm "$root" "$address" >"$root.log" 2>&1 ||
        { tail -n 20 "$root.log"; exit 1; }
    printf 'deb %s bookworm main\n' "$address" >"$root/etc/apt/sources.list"
    copy_network_settings "$root"
    mount_basics "$root"
    enter "$root" / update-ca-certificates >/dev/null 2>&1
    git -c safe.directory='*' clone -q --no-hardlinks "file://$checkout" "$root/root/trabecula"
    say "bare Debian $(cat "$root/etc/debian_version"), $(nproc) cores; $(git -C "$root/root/trabecula" log -1 --format=%h)"
    before=$(du -smx "$root" | cut -f1)
    timed "make setup (the first part of make demo and of make test)" make setup
    grep '^setup: installing' "$root/log"
    say "installed: $(($(du -smx "$root" | cut -f1) - before)) MB"
    timed "make demo after it" make demo
    tail -n 12 "$root/log"
    timed "make demo once more" make demo
    timed "make test ONLY=tests/release, a part of make test" make test ONLY=tests/release
    tail -n 1 "$root/log"
}

case ${1:-} in
    "") (as_root unshare --mount --propagation private sh "$here/first_run.sh" _measure) ;;
    _measure) measure ;;
    *) sed -n '3,11s/^#\{1,\} \{0,1\}//p' "$0"; exit 2 ;;
esac

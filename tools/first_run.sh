#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# How long the README's two commands take from a bare machine: a Debian 12 with nothing but make and git, made by debootstrap
# for this run and thrown away after it; a fresh clone of what is committed here.
#
#   sh tools/first_run.sh          prints the times of the set-up (which both commands do first), the demo, and all tests
#   sh tools/first_run.sh --docs   writes them into docs/first-run.md, too
#
# Needs root or sudo, 5 GB in ${TRABECULA_CACHE:-~/.cache/trabecula}, 30 to 45 minutes. Everything is mounted in a private
# mount namespace; large test data that lie beside the checkout lie beside the clone. Environment: TRABECULA_CACHE,
# TRABECULA_MIRROR.
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

row() {
    # row WORDS SECONDS: a line of the table, also for docs/first-run.md.
    printf '| %s | %s |\n' "$1" "$2" | tee -a "$root.rows"
}

timed() {
    # timed WORDS CMD...: runs a command in the root and says how long it took; its output goes to a log. Sets $seconds.
    words=$1
    shift
    begun=$(date +%s)
    enter "$root" /root/trabecula "$@" >"$root/log" 2>&1 || { tail -n 40 "$root/log"; say "$words failed"; exit 1; }
    seconds=$(($(date +%s) - begun))
    row "$words" "$seconds"
}

leave() {
    if mountpoint -q "$root/root/shared"; then umount -l "$root/root/shared"; fi
    umount_all "$root"
    rm -rf --one-file-system "$root"
}

measure() {
    # Runs as root in a mount namespace of its own.
    need_debootstrap
    rm -rf --one-file-system "$root" "$root.rows"
    mkdir -p "$root"
    trap leave EXIT
    trap 'exit 130' INT TERM HUP
    address=$(mirror)
    debootstrap --variant=minbase --include=ca-certificates,make,git bookworm "$root" "$address" >"$root.log" 2>&1 ||
        { tail -n 20 "$root.log"; exit 1; }
    printf 'deb %s bookworm main\n' "$address" >"$root/etc/apt/sources.list"
    copy_network_settings "$root"
    mount_basics "$root"
    enter "$root" / update-ca-certificates >/dev/null 2>&1
    git -c safe.directory='*' clone -q --no-hardlinks "file://$checkout" "$root/root/trabecula"
    if [ -d "$checkout/../shared" ]; then
        mkdir "$root/root/shared"
        mount --bind -o ro "$checkout/../shared" "$root/root/shared"
    fi
    commit=$(git -C "$root/root/trabecula" log -1 --format=%h)
    say "bare Debian $(cat "$root/etc/debian_version"), $(nproc) cores; $commit"
    before=$(du -smx "$root" | cut -f1)
    timed 'set-up, the first part of both commands: what is missing, by apt, and manifold3d by pip' make setup
    setup=$seconds
    megabytes=$(($(du -smx "$root" | cut -f1) - before))
    grep '^setup: installing' "$root/log"
    timed '`make demo` after it: case 6 and an implant, checked, written, pictured' make demo
    row '**`make demo` from bare**' "**$((setup + seconds))**"
    timed '`make demo` once more' make demo
    timed '`make test` after the set-up' make test
    row '**`make test` from bare**' "**$((setup + seconds))**"
    summary=$(tail -n 1 "$root/log")
    grep -A20 '^skipped, because' "$root/log" || true
    say "$summary; $megabytes MB were installed"
    printf '\nMade by `sh tools/first_run.sh --docs` of %s, Debian %s, %s cores. Tests: %s. %s MB were installed.\n' \
        "$commit" "$(cat "$root/etc/debian_version")" "$(nproc)" "$summary" "$megabytes" >>"$root.rows"
}

write_page() {
    PYTHONPATH=$here /usr/bin/python3 - "$root.rows" <<'PYTHON'
import sys
from pathlib import Path

import generated_page

rows = Path(sys.argv[1]).read_text(encoding="utf-8")
generated_page.write_part("first-run.md", "times", "| step | s |\n|---|---|\n" + rows)
PYTHON
}

case ${1:-} in
    "") (as_root unshare --mount --propagation private sh "$here/first_run.sh" _measure) ;;
    --docs)
        (as_root unshare --mount --propagation private sh "$here/first_run.sh" _measure)
        write_page
        ;;
    _measure) measure ;;
    *) sed -n '3,14s/^#\{1,\} \{0,1\}//p' "$0"; exit 2 ;;
esac

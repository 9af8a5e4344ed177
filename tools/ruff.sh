#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Runs ruff (linter and formatter), in one version for all; installs it by pip into the cache folder when it is missing.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
version=0.17.6
folder=${TRABECULA_CACHE:-$HOME/.cache/trabecula}/ruff-$version
python=/usr/bin/python3

if [ ! -x "$folder/bin/ruff" ]; then
    if ! "$python" -m pip --version >/dev/null 2>&1; then sh "$here/setup.sh"; fi
    printf '%s\n' "ruff: installing by pip into $folder: ruff==$version"
    rm -rf "$folder.part"
    "$python" -m pip install --quiet --disable-pip-version-check --no-input --no-deps --only-binary :all: \
        --root-user-action ignore --target "$folder.part" "ruff==$version" </dev/null
    rm -rf "$folder"
    mv "$folder.part" "$folder"
fi
cd "$here/.."
exec "$folder/bin/ruff" "$@"

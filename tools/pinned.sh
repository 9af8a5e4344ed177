#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# pinned.sh NAME VERSION ARGS...: runs a tool of PyPI in one version for all, from the top of the checkout; installs it by pip
# into the cache folder when it is missing.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
name=$1
version=$2
shift 2
folder=${TRABECULA_CACHE:-$HOME/.cache/trabecula}/$name-$version
python=/usr/bin/python3

if [ ! -x "$folder/bin/$name" ]; then
    if ! "$python" -m pip --version >/dev/null 2>&1; then sh "$here/setup.sh"; fi
    printf '%s\n' "$name: installing by pip into $folder: $name==$version"
    rm -rf "$folder.part"
    "$python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary :all: \
        --root-user-action ignore --target "$folder.part" "$name==$version" </dev/null
    rm -rf "$folder"
    mv "$folder.part" "$folder"
fi
cd "$here/.."
PYTHONPATH=$folder exec "$folder/bin/$name" "$@"

#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# oldest_python.sh PYTHON ARGS...: the tests of what runs without FreeCAD (or ARGS of pytest) on another Python, such as 3.8,
# with packages of its time, in an environment of its own in the cache folder. PYTHON is a program, say that of pyenv.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
python=${1:?the program of a Python, such as ~/.pyenv/versions/3.8.18/bin/python}
shift
version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
folder=${TRABECULA_CACHE:-$HOME/.cache/trabecula}/python-$version

if [ ! -e "$folder/complete" ]; then
    rm -rf "$folder"
    "$python" -m venv "$folder"
    # numpy of 2022, as FreeCAD 0.20 with Python 3.8 has it; exact searches for voxels need scipy 1.9
    "$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: \
        'numpy<1.23' 'scipy>=1.9' matplotlib openpyxl pillow manifold3d pytest
    touch "$folder/complete"
fi
cd "$here/.."
[ $# -gt 0 ] || set -- tests/core
exec "$folder/bin/python" -m pytest -q -p no:cacheprovider "$@"

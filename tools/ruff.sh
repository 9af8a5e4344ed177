#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Runs ruff (linter and formatter), in one version for all.
set -eu

exec sh "$(dirname "$0")/pinned.sh" ruff 0.17.6 "$@"

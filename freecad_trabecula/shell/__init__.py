# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python3 -m freecad_trabecula."""

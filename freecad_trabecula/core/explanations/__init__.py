# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why each number is what it is: formula, source, second route; one entry per number that is shown."""

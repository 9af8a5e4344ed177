# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers to kernel and back: no document, no window."""

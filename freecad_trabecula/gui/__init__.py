# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands, panels, view providers, preview. Nothing here computes."""

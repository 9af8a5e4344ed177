# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a document stores and computes again: proxies, whose execute is a few calls."""

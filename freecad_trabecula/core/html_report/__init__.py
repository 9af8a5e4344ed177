# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report in one file: the pages of reports, their pictures and why their numbers are what they are, as HTML."""

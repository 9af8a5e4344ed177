# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slice analysis (thesis chapter 5): triangles -> contours -> profiles -> comparison; docs/analysis.md has the map."""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxel designs (thesis chapter 6): profiles -> layer counts -> tables -> voxels; docs/voxels.md has the map."""

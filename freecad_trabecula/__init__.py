# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecula: trabecular (bone-like) structures in FreeCAD.

``core`` is pure (numpy, no FreeCAD), ``geometry`` speaks to the kernel, ``features`` are the objects of documents,
``make`` is the scripting interface, ``shell`` the command line, ``gui`` the window. docs/architecture.md has the map.
Importing this package imports nothing else, so that it is safe in Init.py and in any Python.
"""

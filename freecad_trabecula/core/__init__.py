# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pure core: numpy only, no FreeCAD; data in the order in which it flows.

``streams``, ``laws``, ``parameters``: what the user chose. ``sites`` (P, 3) mm -> ``pores`` (P, M, 2) ->
``couplings`` (C, 2)
-> ``paths`` (R, 2, 4, 3) -> ``rods`` (R, K, m, 3) -> ``wireframe`` (all of it, mended) -> ``meshes``, ``booleans``,
``field``, ``rays``.
"""

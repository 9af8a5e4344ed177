# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a wireframe to the bodies that its channels leave of an envelope; layers on faces of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict

import numpy as np
import Part

from ..core import wireframe as core
from ..core.bodies import Bodies, wireframe_bodies
from ..core.layers import Patch, welded_patch
from ..core.parameters import LayerParameters, ScaffoldParameters
from ..core.progress import Progress, silent
from ..core.wireframe import Wireframe, WireframeParameters
from ..errors import KernelError
from .design import SitedFace
from .envelopes import Envelope
from .vectors import point_array

_SAME_PLACE = 5  # decimals, mm, at which a node's point is known again


def make_bodies(
    parameters: WireframeParameters,
    wireframe: Wireframe,
    envelope: Envelope,
    faces: Dict[str, SitedFace],
    scaffold: ScaffoldParameters,
    progress: Progress = silent,
) -> Bodies:
    """Return scaffold, channels, loose pieces and voids of a design, with their checks.

    Parameters
    ----------
    parameters : WireframeParameters
        Of the wireframe.
    wireframe : Wireframe
    envelope : Envelope
    faces : dict of SitedFace, by label
    scaffold : ScaffoldParameters
    progress : callable

    Raises
    ------
    EnvelopeError
        If a face with a layer is not there.
    TrabeculaError
        As ``core.bodies.wireframe_bodies`` says.
    """
    layers = labelled(scaffold.layers, faces, envelope)
    patches = [face_patch(face_of(name, faces, envelope), envelope.deflection) for name in layers.faces]
    rods = core.skin(wireframe, parameters.rods)
    scaffold = replace(scaffold, layers=layers)
    return wireframe_bodies(wireframe, rods, parameters.couplings, envelope.mesh, scaffold, patches, progress)


def face_of(name: str, faces: Dict[str, SitedFace], envelope: Envelope) -> Part.Face:
    """Return a face by its label, or by FreeCAD's name."""
    return faces[name].face if name in faces else envelope.face(name)


def labelled(layers: LayerParameters, faces: Dict[str, SitedFace], envelope: Envelope) -> LayerParameters:
    """Return the layers with faces under the labels that couplings use, where a face has one."""
    names = []
    for name in layers.faces:
        face = face_of(name, faces, envelope)
        names.append(next((label for label, one in faces.items() if one.face.isSame(face)), name))
    return replace(layers, faces=tuple(dict.fromkeys(names)))


def face_patch(face: Part.Face, deflection: float) -> Patch:
    """Return the triangles of a face with the surface's normals.

    Parameters
    ----------
    face : Part.Face
        Of a proper solid: its oriented normal points out.
    deflection : float, mm

    Raises
    ------
    KernelError
        If the kernel gives no triangles.
    """
    own = face.copy()  # without the triangles that the solid may have already
    points, triangles = own.tessellate(deflection)
    if not triangles:
        raise KernelError(f"the kernel made no triangles of a face at a deflection of {deflection:g} mm")
    vertices, numbers = point_array(points), np.array(triangles, np.int64)
    return welded_patch(vertices, _normals(own, vertices, numbers), numbers)


def _normals(face: Part.Face, vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Unit outer normals (P, 3): the surface's, at its poles those of the triangles around.

    The nodes' parameters come with the triangles, in an order of their own; asking the surface for the parameters of
    a point takes 6 ms each on a spline of bone.
    """
    a, b, c = vertices[triangles].transpose(1, 0, 2)
    around = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(around, triangles[:, k], np.cross(b - a, c - a))
    around /= np.linalg.norm(around, axis=1, keepdims=True).clip(1e-300)
    number = {tuple(row): k for k, row in enumerate(np.round(vertices, _SAME_PLACE).tolist())}
    nodes = face.getUVNodes()
    places = np.round(point_array([face.valueAt(*node) for node in nodes]), _SAME_PLACE).tolist()
    for node, place in zip(nodes, places):
        k = number.get(tuple(place))
        try:
            normal = np.array(face.normalAt(*node))
        except (Part.OCCError, RuntimeError):
            continue
        if k is None:
            continue
        # the kernel does not turn the normal of every kind of face with its orientation
        around[k] = normal if normal @ around[k] > 0 else -normal
    return around

# SPDX-License-Identifier: LGPL-2.1-or-later
"""From document objects back to a job."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..core.job import Job, job_to_json
from ..core.parameters import PrismParameters, ScaffoldParameters
from ..errors import EnvelopeError, ParameterError
from ..geometry.files import replacing
from .arguments import given_object
from .base import read_parameters
from .envelope import source_of
from .face_sites import FaceSites
from .feature import is_a
from .prism_sites import PrismSites
from .relations import products_of, type_of
from .wireframe import Wireframe


def job_of(wireframe: Any, scaffold: Any = None, envelope: str = "") -> Job:
    """Return the job of a wireframe object, and of a scaffold object if one is given.

    Parameters
    ----------
    wireframe : document object
    scaffold : document object, optional
    envelope : str
        File of the envelope; none means the file from which it was made. A prism needs none.

    Raises
    ------
    ParameterError
        If a job cannot hold the design: sites on a prism and on faces together, a prism that was moved.
    EnvelopeError
        If the envelope is neither a box nor made from a file.

    Examples
    --------
    >>> from dataclasses import replace
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> job = preset("case6")
    >>> replace(make.job_of(make.make_design(FreeCAD.newDocument(), job).wireframe), name="case6") == job
    True
    """
    parameters = given_object(wireframe, Wireframe).Proxy.parameters(wireframe)
    prisms = [one.Proxy.parameters(one) for one in wireframe.Sites if is_a(one, PrismSites)]
    faces = tuple(one.Proxy.parameters(one) for one in wireframe.Sites if is_a(one, FaceSites))
    if prisms and (faces or len(prisms) > 1):
        raise ParameterError(
            "a job must have the sites of 1 prism, or those of faces, "
            f"got {len(prisms)} prisms and {len(faces)} faces in {wireframe.Label}"
        )
    file, solid = (envelope, "") if envelope else source_of(wireframe.Envelope)
    if wireframe.Envelope.TypeId == "Part::Box" and not envelope:
        _check_place(wireframe.Envelope)
        prisms = prisms or [box_parameters(wireframe.Envelope)]
    if not prisms and not file:
        raise EnvelopeError(
            f"an envelope must be a box or come from a file to be kept in a job, got {wireframe.Envelope.Label}; "
            "export it as STEP and name that file"
        )
    return Job(
        name=wireframe.Document.Label,
        envelope="" if prisms else file,
        solid="" if prisms else solid,
        prism=prisms[0] if prisms else None,
        faces=faces,
        pores=parameters.pores,
        path=parameters.path,
        couplings=parameters.couplings,
        rods=parameters.rods,
        scaffold=read_parameters(scaffold, ScaffoldParameters) if scaffold else ScaffoldParameters(),
        edits=parameters.edits,
        seed=parameters.seed,
    )


def write_job(wireframe: Any, path: str) -> None:
    """Write the job of a wireframe object, and of its scaffold if there is one, into a file.

    Raises
    ------
    TrabeculaError
        As ``job_of``; or the file cannot be written: what stood under that name before stays.
    """
    scaffold = next((one for one in products_of(wireframe) if type_of(one).endswith("Scaffold")), None)
    text = job_to_json(job_of(wireframe, scaffold))
    with replacing(path) as part:
        Path(part).write_text(text, encoding="utf-8")


def box_parameters(box: Any) -> PrismParameters:
    """Return the parameters of a prism without sites of its own."""
    edges = (box.Length.Value, box.Width.Value, box.Height.Value)
    return PrismParameters(*edges, a_x=0.0, a_y=0.0, a_z=0.0)


def _check_place(box: Any) -> None:
    if not box.Placement.isIdentity():
        raise ParameterError(
            "the prism of a job has a corner at the origin and its edges along X, Y, Z: the box's placement must be "
            f"the identity, got {box.Placement} of {box.Label}"
        )

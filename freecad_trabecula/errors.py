# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of Trabecula: one base class, one line each. A message states the rule, the value and its unit."""


class TrabeculaError(Exception):
    """Base of every error raised on purpose."""


class ParameterError(TrabeculaError, ValueError):
    """A value chosen by the user breaks a rule."""


class EnvelopeError(TrabeculaError, ValueError):
    """The body to be filled cannot be used: not one closed solid, inside out, a face that is not its own."""


class MeshError(TrabeculaError, ValueError):
    """A triangle mesh is not what it must be: open, empty, inside out."""


class ContourError(TrabeculaError, ValueError):
    """Contours, or a file of them, are not what they must be: open, crossing, out of order."""


class InfeasibleError(TrabeculaError, ValueError):
    """No voxel design has the layer counts asked for; the message names the layers that contradict each other."""


class ExactnessError(TrabeculaError, RuntimeError):
    """A search for a voxel design with the exact layer counts gave up; none that is nearly right is passed on."""


class KernelError(TrabeculaError, RuntimeError):
    """The geometry kernel failed, or gave a result that a second route contradicts."""


class DependencyError(TrabeculaError, ImportError):
    """An optional package is missing; the message holds the command that installs it."""


class ExportError(TrabeculaError, OSError):
    """A file could not be written or read; nothing half written is left."""


class Cancelled(TrabeculaError):
    """The user stopped the work; raised by a progress callback."""

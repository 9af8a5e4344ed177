# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of classes and properties are a file format: what is listed here is in users' files and expressions.

A name may be added. One that is changed or taken away needs a migration (``Feature.MIGRATIONS``) that also rewrites
expressions, and a file of the version before in tests/data that a test opens.
"""

import sys
import unittest
from dataclasses import replace
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.parameters import FaceParameters
from freecad_trabecula.features.voxel_design import VoxelDesign

#: Type: module and class of the proxy, FreeCAD's type, names of properties.
NAMES = {
    "Trabecula::PrismSites": (
        "freecad_trabecula.features.prism_sites.PrismSites",
        "Part::FeaturePython",
        "BorderX BorderY BorderZ Box Count SchemaVersion SitesX SitesY SitesZ Status",
    ),
    "Trabecula::FaceSites": (
        "freecad_trabecula.features.face_sites.FaceSites",
        "Part::FeaturePython",
        "BorderU BorderV Count DirectionU DirectionV Face FaceMark FaceName MarkedFace Origin OriginGiven ResultKey "
        "SchemaVersion SpacingU SpacingV Status",
    ),
    "Trabecula::Wireframe": (
        "freecad_trabecula.features.wireframe.Wireframe",
        "Part::FeaturePython",
        "CouplingTable Couplings Edits Envelope Failed Numbers Outside PathBox PathChoice PathKind PathPoints "
        "PathTensionFirstDirection PathTensionFirstExpression PathTensionFirstHigh PathTensionFirstLaw "
        "PathTensionFirstLow PathTensionSecondDirection PathTensionSecondExpression PathTensionSecondHigh "
        "PathTensionSecondLaw PathTensionSecondLow PoreAreas PoreCorners PoreLayout PorePullDirection "
        "PorePullExpression PorePullHigh PorePullLaw PorePullLow PoreScatter PoreSections PoreSizeDirection "
        "PoreSizeExpression PoreSizeHigh PoreSizeLaw PoreSizeLow PoreSizes PoreTurnDirection "
        "PoreTurnExpression PoreTurnHigh PoreTurnLaw PoreTurnLow Recoveries ResultKey RodDeflection RodLean "
        "RodRedraws RodStations Rods SchemaVersion Seed Sites Status Structure Warnings",
    ),
    "Trabecula::Network": (
        "freecad_trabecula.features.network.Network",
        "Part::FeaturePython",
        "AutoUpdate Difference LargestDifference MeshVolume Rebuilt ResultKey RodKeys RodMeshVolumes RodNames "
        "RodVolume RodVolumes Rods SchemaVersion Status UpToDate Wireframe",
    ),
    "Trabecula::Scaffold": (
        "freecad_trabecula.features.scaffold.Scaffold",
        "Mesh::FeaturePython",
        "AddedVolume AutoUpdate Cell ChannelVolume Checks Engine EngineUsed EnvelopeVolume KeepLoose "
        "LayerClosed LayerFaces LayerSide LayerThickness LoosePieces LooseVolume MemoryBudget Notes Openings "
        "Pieces Porosity Reason ResultKey ScaffoldVolume SchemaVersion Seconds Status SumPorosity TimeBudget "
        "UnionPorosity UpToDate VoidVolume Voids Watertight Wireframe",
    ),
    "Trabecula::SolidScaffold": (
        "freecad_trabecula.features.solid_scaffold.SolidScaffold",
        "Part::FeaturePython",
        "AutoUpdate Cell Complete Difference Engine KeepLoose LayerClosed LayerFaces LayerSide LayerThickness "
        "MemoryBudget MeshVolume Porosity Reason ResultKey RodsCut RodsWanted ScaffoldVolume SchemaVersion Seconds "
        "SolidVolume Status TimeBudget UpToDate Wireframe",
    ),
    "Trabecula::Body": (
        "freecad_trabecula.features.scaffold.Body",
        "Mesh::FeaturePython",
        "Facets ResultKey Role Scaffold SchemaVersion Status",
    ),
    "Trabecula::Analysis": (
        "freecad_trabecula.features.analysis.Analysis",
        "App::FeaturePython",
        "AutoUpdate BoneFraction Checks Contours Deflection Envelope File MeshVolume Morphometry Notes "
        "Numbers ResultKey SchemaVersion Seconds SliceAt SliceAxes SliceCompensation SliceFill "
        "SliceFilterClosed SliceFilterOpen SliceGap SliceHeights SliceHigh SliceIterations SliceLeastArea "
        "SliceLow SliceRange SliceRodRatio SliceSmoothing SliceThickness SliceVolume Slices Source "
        "SpoiltSlices Status Structure Triangles Unit UnitFound UpToDate",
    ),
    "Trabecula::VoxelDesign": (
        "freecad_trabecula.features.voxel_design.VoxelDesign",
        "Mesh::FeaturePython",
        "Alpha AutoUpdate Beta BoneFraction ClosedCavities Components CornerContacts CurveEdges CurveX CurveY "
        "CurveZ EdgeContacts Envelope Exact File LargestFraction LayersX LayersY LayersZ MeshVolume Notes "
        "Numbers ResultKey SchemaVersion Seconds Source Status Structure Surface TrabeculaDeviation UpToDate "
        "VoxelAreas VoxelBoundary VoxelCapAlpha VoxelCapBeta VoxelContacts VoxelCorrection VoxelDirection "
        "VoxelField VoxelPairing VoxelRods VoxelSeed VoxelSize VoxelSolver VoxelStrategy VoxelThickness "
        "VoxelTotal VoxelTrabeculae VoxelTries VoxelVoid VoxelVolume VoxelWavelength Voxels Watertight",
    ),
}


@unittest.skipUnless(manifold_available(), NO_BOOLEANS)
class NamesTest(DocumentCase):
    def test_all_names_that_files_hold_are_still_there(self):
        job = small_job(n=2)
        job = replace(job, couplings=tuple(replace(coupling, limit=1) for coupling in job.couplings))
        design = make.make_design(self.document, job, ("network", "scaffold"))
        faces = make.make_face_sites(design.envelope, FaceParameters("Face1"))
        bodies = make.body_objects(design.scaffold)
        solid = make.make_solid_scaffold(design.wireframe)
        analysis = make.make_analysis(self.document, design.envelope)
        voxels = self.document.addObject("Mesh::FeaturePython", "Voxels")
        VoxelDesign(voxels)
        design_objects = (design.wireframe, design.network, design.scaffold, solid, bodies[0])
        objects = (*design.sites, faces, *design_objects, analysis, voxels)
        self.assertEqual({obj.Proxy.Type for obj in objects}, set(NAMES))
        for obj in objects:
            with self.subTest(type=obj.Proxy.Type):
                proxy, type_id, names = NAMES[obj.Proxy.Type]
                self.assertEqual(f"{type(obj.Proxy).__module__}.{type(obj.Proxy).__name__}", proxy)
                self.assertEqual(obj.TypeId, type_id)
                self.assertEqual(set(names.split()) - set(obj.PropertiesList), set())

    def test_roles_of_bodies_are_a_part_of_the_format(self):
        design = make.make_design(self.document, small_job(), ("scaffold",))
        body = make.body_objects(design.scaffold)[0]
        self.assertEqual(body.getEnumerationsOfProperty("Role"), ["channels", "loose", "voids"])

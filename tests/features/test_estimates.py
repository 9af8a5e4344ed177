# SPDX-License-Identifier: LGPL-2.1-or-later
"""What objects will take, before they are computed: counts are those that come, more work takes longer.

No test here looks at a clock: the seconds beside what came are those of ``tools/estimates.py``.
"""

from dataclasses import replace

import Part
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core import estimates as core
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.variants import RAYS, SCAFFOLD
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import TrabeculaError
from freecad_trabecula.features import estimates, results
from freecad_trabecula.features.estimates import estimate_design, variants_work, work_of
from freecad_trabecula.shell.design import Stopwatch, make_job


def box_of(job):
    return Part.makeBox(job.prism.l, job.prism.w, job.prism.h)


class DesignEstimateTest(DocumentCase):
    def noted(self, job, envelope):
        """Numbers of rods and of faulty ones that the estimate of a job is made of."""
        seen, own = [], estimates.design_work
        estimates.design_work = lambda *counts: (seen.append(counts), own(*counts))[1]
        try:
            estimate_design(job, envelope)
        finally:
            estimates.design_work = own
        return seen[0]

    def test_rods_and_faulty_ones_are_counted_before_they_are_made(self):
        for name in ("case1", "case6"):
            job = preset(name)
            rods, faulty = self.noted(job, box_of(job))
            results.clear()
            wireframe = make.make_design(self.document, job).wireframe
            self.assertEqual((rods, faulty), (wireframe.Rods, len(wireframe.Recoveries)))

    def test_more_rods_and_a_finer_scaffold_take_longer(self):
        few, many = (estimate_design(preset(name), box_of(preset(name))) for name in ("case1", "case6"))
        self.assertLess(few.seconds, many.seconds)
        self.assertLess(few.memory, many.memory)
        job = preset("case6")
        cells = [replace(job, scaffold=replace(job.scaffold, engine="field", cell=cell)) for cell in (0.2, 0.1)]
        coarse, fine = (estimate_design(one, box_of(one)) for one in cells)
        self.assertLess(coarse.seconds, fine.seconds)

    def test_a_design_whose_couplings_are_off_takes_nothing(self):
        job = preset("case1")
        job = replace(job, couplings=tuple(replace(one, on=False) for one in job.couplings))
        self.assertEqual(estimate_design(job, box_of(job)).seconds, 0.0)

    def test_the_shell_says_it_before_the_rods_are_made(self):
        said = []
        job = preset("case1")

        def tell(work):
            said.append((work, [obj.Name for obj in self.document.Objects]))

        make_job(self.document, job, Stopwatch(lambda kind, **more: None), tell)
        ((work, names),) = said
        self.assertEqual(len(names), 1)  # the envelope
        self.assertEqual(work, estimate_design(job, box_of(job)))


class RecomputeEstimateTest(DocumentCase):
    def test_an_analysis_is_as_heavy_as_its_planes_and_measures(self):
        torus = self.document.addObject("Part::Torus", "Torus")
        torus.Radius1, torus.Radius2 = 5, 2
        self.document.recompute()
        obj = make.make_analysis(self.document, torus, SliceParameters(thickness=1.0))
        works = [work_of([obj])]
        obj.SliceThickness = 0.001
        works.append(work_of([obj]))
        obj.Morphometry = True
        works.append(work_of([obj]))
        self.assertEqual(sorted(work.seconds for work in works), [work.seconds for work in works])
        self.assertEqual([work.is_heavy for work in works][::2], [False, True])

    def test_a_voxel_design_is_as_heavy_as_its_cells(self):
        bracket = self.document.addObject("Part::Feature", "Bracket")
        bracket.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 9))
        obj = make.make_voxel_design(self.document, bracket, VoxelParameters(size=(0.5, 0.5, 0.5)))
        few = work_of([obj])
        obj.VoxelSize = (0.02, 0.02, 0.02)  # 200^3
        many = work_of([obj])
        self.assertAlmostEqual(many.seconds / few.seconds, 25**3)
        self.assertTrue(many.is_heavy)

    def test_a_wireframe_up_to_date_takes_nothing_and_its_bodies_count(self):
        design = make.make_design(self.document, preset("case1"), ("network", "scaffold"))
        wireframe, network, scaffold = design.wireframe, design.network, design.scaffold
        self.assertEqual(work_of([wireframe]).seconds, 0.0)
        bodies = [work_of([wireframe, *some]).seconds for some in ((network,), (scaffold,), (network, scaffold))]
        self.assertAlmostEqual(bodies[0] + bodies[1], bodies[2])
        wireframe.Seed = 9
        own = work_of([wireframe]).seconds
        self.assertGreater(own, 0.0)
        self.assertAlmostEqual(work_of([wireframe, network, scaffold]).seconds, own + bodies[2])
        self.assertIsNone(results.find("wireframe", wireframe.Proxy.key(wireframe)), "it was computed to be estimated")

    def test_bodies_of_a_wireframe_that_shows_nothing_are_not_counted(self):
        design = make.make_design(self.document, preset("case1"), ("scaffold",))
        results.clear()
        design.wireframe.ResultKey = ""
        rods_alone = work_of([design.wireframe]).seconds
        self.assertEqual(work_of([design.wireframe, design.scaffold]).seconds, rods_alone)

    def test_what_cannot_be_computed_has_no_estimate(self):
        obj = make.make_analysis(self.document, make.make_box(self.document, 1, 2, 3), SliceParameters(thickness=1.0))
        obj.Source = None
        with self.assertRaisesRegex(TrabeculaError, "must have a source or a file"):
            work_of([obj])

    def test_other_seeds_take_so_many_times_what_one_takes_and_scaffolds_more(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        rays, scaffold = variants_work(wireframe, 7, RAYS), variants_work(wireframe, 7, SCAFFOLD)
        self.assertAlmostEqual(rays.seconds, 7 * core.rod_variant_work(75, len(wireframe.Recoveries)).seconds)
        self.assertEqual(scaffold.memory, variants_work(wireframe, 1, SCAFFOLD).memory)
        self.assertGreater(scaffold.seconds, rays.seconds)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The network in the document: only the rods that an edit touches are built again, also after the file was opened."""

import sys
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.errors import KernelError, ParameterError
from freecad_trabecula.features import network, results
from freecad_trabecula.features.on_demand import OUT_OF_DATE


class NetworkTest(DocumentCase):
    def network(self, job=None):
        return make.make_network(self.make(job or small_job(kind="centre")).wireframe)

    def test_solids_are_valid_and_have_the_volumes_of_the_meshes(self):
        rods = self.network()
        self.assertEqual((rods.Rods, rods.Rebuilt, len(rods.Shape.Solids)), (27, 27, 27))
        self.assertTrue(all(solid.isValid() and solid.Volume > 0 for solid in rods.Shape.Solids))
        self.assertLess(rods.LargestDifference, 0.1)
        self.assertAlmostEqual(rods.RodVolume.Value / rods.MeshVolume.Value, 1, 3)
        self.assertAlmostEqual(rods.RodVolume.Value, sum(solid.Volume for solid in rods.Shape.Solids), 9)

    def test_each_solid_stands_at_the_sites_of_its_rod(self):
        rods = self.network()
        wireframe = make.wireframe_of(rods.Wireframe)
        self.assertEqual(tuple(rods.RodNames), wireframe.names)
        for solid, path in zip(rods.Shape.Solids, wireframe.paths):
            box = solid.BoundBox
            box.enlarge(1e-6)
            for point in (path[0, 0], path[0, 3], path[1, 3]):
                self.assertTrue(box.isInside(*point.tolist()))

    def test_one_pore_of_case_6_rebuilds_its_one_rod_within_a_second(self):
        rods = self.network(preset("case6"))
        before = dict(zip(rods.RodNames, rods.RodKeys))
        started = time.process_time()
        make.set_pore(rods.Wireframe, "Face3.4.4", 0.55)
        self.document.recompute()
        self.assertLess(time.process_time() - started, 1)
        after = dict(zip(rods.RodNames, rods.RodKeys))
        touched = [name for name in after if after[name] != before[name]]
        self.assertEqual(len(touched), 1)
        self.assertTrue(touched[0].startswith("Face3.4.4-"))
        self.assertEqual((rods.Rebuilt, rods.Rods), (1, 147))

    def test_one_coupling_switched_off_builds_nothing_and_on_again_its_rods(self):
        rods = self.network(small_job(n=4))
        couplings = list(rods.Wireframe.Couplings)
        rods.Wireframe.Couplings = [couplings[0].replace("}", ', "on": false}'), *couplings[1:]]
        self.document.recompute()
        self.assertEqual((rods.Rods, rods.Rebuilt), (32, 0))
        rods.Wireframe.Couplings = couplings
        self.document.recompute()
        self.assertEqual((rods.Rods, rods.Rebuilt), (48, 16))

    def test_after_opening_the_file_an_edit_still_rebuilds_one_rod(self):
        before = {round(solid.Volume, 6) for solid in self.network().Shape.Solids}
        rods = self.reopened().getObject("Network")
        self.document.recompute(None, True)
        self.assertIsNone(results.find("network", rods.ResultKey))
        self.assertEqual(rods.State, ["Up-to-date"])
        make.set_pore(rods.Wireframe, "Face1.2.2", 0.7)
        self.document.recompute()
        self.assertEqual((rods.Rods, rods.Rebuilt), (27, 1))
        self.assertEqual(len(before & {round(solid.Volume, 6) for solid in rods.Shape.Solids}), 26)

    def test_a_network_that_was_moved_by_hand_stays_there_and_is_not_built_again(self):
        rods = self.network()
        box = rods.Shape.BoundBox
        rods.Placement.Base.z = 5
        make.set_pore(rods.Wireframe, "Face1.2.2", 0.7)
        self.document.recompute()
        self.assertEqual(rods.Rebuilt, 1)
        self.assertAlmostEqual(rods.Shape.BoundBox.ZMax, box.ZMax + 5, 2)
        self.assertEqual(rods.Placement.Base.z, 5)

    def test_without_auto_update_it_waits(self):
        rods = self.network()
        rods.AutoUpdate = False
        rods.Wireframe.Seed = 4
        self.document.recompute()
        self.assertEqual((rods.Status, rods.UpToDate), (OUT_OF_DATE, False))
        make.update(rods)
        self.assertTrue(rods.UpToDate)
        self.assertEqual(rods.Rebuilt, 27)

    def test_the_rod_of_a_face_is_found(self):
        rods = self.network()
        for number in (1, 7, len(rods.Shape.Faces)):
            name = make.rod_at(rods, f"Face{number}").name
            solid = rods.Shape.Solids[list(rods.RodNames).index(name)]
            face = rods.Shape.Faces[number - 1]
            self.assertTrue(any(face.isSame(one) for one in solid.Faces))


class RefusalTest(DocumentCase):
    def test_a_solid_whose_volume_its_mesh_contradicts_puts_the_network_in_error_with_its_name(self):
        rods = make.make_network(self.make(small_job()).wireframe)
        count = len(rods.Shape.Faces)
        good = results.find("network", rods.ResultKey)
        volumes = good.volumes.copy()
        volumes[5] *= 1.01
        results.keep("network", rods.ResultKey, good._replace(volumes=volumes))
        rods.ResultKey = ""
        rods.touch()
        self.document.recompute()
        self.assertFalse(rods.isValid())
        self.assertRegex(rods.Status, f"agree within 0.2 % .* for rod {good.names[5]} and 1 such rods")
        self.assertEqual(len(rods.Shape.Faces), count)
        with self.assertRaises(KernelError):
            network.check(good._replace(volumes=volumes))

    def test_a_network_needs_a_wireframe(self):
        box = make.make_box(self.document)
        with self.assertRaisesRegex(ParameterError, "must be of the kind wireframe, got Envelope"), self.unchanged():
            make.make_network(box)

    def test_a_wireframe_in_error_leaves_the_network_as_it_was(self):
        rods = make.make_network(self.make(small_job()).wireframe)
        count = len(rods.Shape.Solids)
        rods.Wireframe.PoreSizeHigh = 0.1
        self.document.recompute()
        self.assertFalse(rods.Wireframe.isValid())
        self.assertEqual(len(rods.Shape.Solids), count)
        with self.assertRaisesRegex(ParameterError, "low <= high"):
            make.update(rods)
        rods.Wireframe.PoreSizeHigh = 0.8
        self.document.recompute()
        self.assertTrue(rods.isValid() and rods.UpToDate)

    def test_a_face_that_is_not_there_has_no_rod(self):
        rods = make.make_network(self.make(small_job()).wireframe)
        for name in ("Face9999", "Face0", "Edge1", ""):
            with self.assertRaisesRegex(ParameterError, "must be one of Face1..Face"):
                make.rod_at(rods, name)

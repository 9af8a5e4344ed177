# SPDX-License-Identifier: LGPL-2.1-or-later
"""An anatomical design whose properties change: its envelope is no box, its faces are curved, its rods need mending."""

import os
import unittest
from pathlib import Path

from window import Heartbeat, WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset

DATA = Path(os.environ.get("TRABECULA_DATA", str(Path(__file__).resolve().parents[3] / "shared" / "data")))
LONGEST = 0.2  # s of processor time that the window's thread may spend at once


@unittest.skipUnless((DATA / "anatomy" / "femur_metaphysis.step").is_file(), f"no anatomical solids in {DATA}")
class AnatomyTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.design = make.make_design(self.document, preset("femur"))

    def wait_until_shown(self):
        every = [self.design.wireframe, *self.design.sites]
        done = wait(lambda: all(one.ResultKey == one.Proxy.key(one) for one in every), 240)
        self.assertTrue(done, [one.Status for one in every])
        settle(0.3)

    def change(self, action):
        """Change a property as the property editor does; return the processor time that the thread spent at once."""
        with Heartbeat() as beat:
            action()
            self.document.recompute()
            settle(0.05)
            self.wait_until_shown()
        return beat.busiest

    def test_the_window_never_computes_for_long(self):
        wireframe, sites = self.design.wireframe, self.design.sites[0]
        self.assertLess(self.change(lambda: setattr(wireframe, "Seed", 3)), LONGEST)
        self.assertLess(self.change(lambda: setattr(sites, "SpacingU", sites.SpacingU.Value * 1.1)), LONGEST)

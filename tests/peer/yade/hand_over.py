# SPDX-License-Identifier: GPL-3.0-or-later
"""The packing of make_packing.py in YADE's memory, handed over to granum: the same as by its files.

    yade -j1 -n -x hand_over.py <folder of make_packing.py> <granum>/share/yade <folder of the package granum>
"""

import os
import sys

here, share, package = sys.argv[1:4]
sys.argv[1:] = ["packing", share]
exec(open(os.path.join(here, "make_packing.py")).read())

sys.path.insert(0, package)
import granum
import numpy as np

in_memory = granum.from_yade(O)
of_files = granum.read("packing.grains", "packing.contacts")
assert len(in_memory.contacts) == len(of_files.contacts) > 100
np.testing.assert_array_equal(in_memory.position, of_files.position)
for name in ("i", "j", "overlap", "normal_stiffness", "tangential_stiffness", "tangential_force"):
    np.testing.assert_array_equal(getattr(in_memory.contacts, name), getattr(of_files.contacts, name), name)
for name in ("branch", "normal_force"):  # whose last digit depends on the order of a sum
    a, b = getattr(in_memory.contacts, name), getattr(of_files.contacts, name)
    np.testing.assert_allclose(a, b, rtol=0, atol=1e-14 * np.abs(b).max(), err_msg=name)
print("the packing in memory is that of the files")

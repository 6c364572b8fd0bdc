# SPDX-License-Identifier: GPL-3.0-or-later
# What h5py (Debian: python3-h5py) makes of the file that write_sample.cpp wrote:  check_packing.py <file>
import sys

import h5py

units = {
    "cell": "m",
    "time": "s",
    "grains/position": "m",
    "grains/radius": "m",
    "contacts/branch": "m",
    "contacts/normal_force": "N",
    "contacts/tangential_force": "N",
    "contacts/normal_stiffness": "N/m",
    "wall_contacts/overlap": "m",
}
with h5py.File(sys.argv[1]) as file:
    assert file.attrs["format"] == "granum packing"
    assert file.attrs["signs"] == "compression positive"
    for name, unit in units.items():
        assert file[name].attrs["unit"] == unit, name
        assert file[name].attrs["meaning"], name
    assert file["cell"][:].tolist() == [[4e-3, 0, 0], [0, 5e-3, 0], [1e-3 / 3, 0, 6e-3]]
    assert file["periodic"][:].tolist() == [1, 1, 0]
    assert file["step"][:].tolist() == [20] and file["time"][:].tolist() == [0.1]
    assert file["grains/id"][:].tolist() == [-4, 7, 10**12]
    assert file["grains/position"].shape == (3, 3)
    assert file["grains/position"][1].tolist() == [1.9e-3, 2e-3, 2e-3]
    assert file["contacts/i"][:].tolist() == [0, 0] and file["contacts/j"][:].tolist() == [1, 2]
    assert file["contacts/normal_force"][:].tolist() == [2, 1 / 3]
    assert file["contacts/tangential_force"][1].tolist() == [0.1, -0.2, 0]
    assert file["contacts/sliding"][:].tolist() == [0, 1]
    assert file["wall_contacts/j"][:].tolist() == [5]

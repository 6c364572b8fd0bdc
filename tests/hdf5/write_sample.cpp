// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what check_packing.py and h5dump read:  write_hdf5_sample <file>
#include <granum/io/packing_hdf5.hpp>

#include "sample.hpp"

int main(int, char** arguments) {
  granum::io::write_packing_hdf5(arguments[1], granum::samples::hdf5_sample(), granum::io::Existing::replace);
}

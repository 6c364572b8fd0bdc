# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by lammps_growth.sh and lammps_replicated.sh.

# deck_of_copies GRANUM FOLDER PROBE_PRESSURES SHARE
# Goes to a deck of granum in FOLDER and brings 1,000 dense spheres to rest under 100 kPa there, with LAMMPS. copies.lmp
# then reads them, sets ${copies} of them side by side along each axis, moves each grain by SHARE of a mean overlap at
# random, as copies that are alike would stay so, and asks for 200 kPa, at which the servo has to move.
deck_of_copies() {
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 # Open MPI in a machine that only has root
  "$1" export lammps --grains 1000 --force --out "$2" --set study.contacts=sphere --set study.densities=dense \
    --set study.pressures=100kPa,200kPa,300kPa --set study.probe_pressures="$3" >&2
  cd -- "$2/dense-1"
  cat >start.lmp <<'END'
include scene.lmp
include in.prepare
include rest.lmp
write_data rested.data nofix
END
  lmp -in start.lmp >start.out
  cat >copies.lmp <<END
variable pressure delete
variable pressure string 200000 # [Pa]
include scene.lmp
variable state delete
include settings.lmp
read_data rested.data
replicate \${copies} \${copies} \${copies}
variable nudge equal $4*v_overlap # [m]
displace_atoms all random \${nudge} \${nudge} \${nudge} 4928459
variable mu equal \${friction} # [1]
variable tolerance equal \${iso_tolerance} # [1]
variable inertial_number equal \${iso_inertial_number} # [1]
include model.lmp
END
}

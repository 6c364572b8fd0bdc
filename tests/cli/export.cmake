# SPDX-License-Identifier: GPL-3.0-or-later
foreach(contact cone flat power-law)
  granum_cli_test("export: LAMMPS has no ${contact}" EXIT 2
    STDERR "^granum: error: LAMMPS has no contact law for study\\.contacts = ${contact}. supported is sphere"
    ARGS export lammps --set study.contacts=sphere,${contact} --out refused)
endforeach()
granum_cli_test("export: another code" EXIT 2 STDERR "^granum: error: " ARGS export yade --out refused)
granum_cli_test("export: no folder" EXIT 2 STDERR "^granum: error: --out is required"
  ARGS export lammps --set study.contacts=sphere)
granum_cli_test("export: unknown start" EXIT 2 STDERR "^granum: error: --start: "
  ARGS export lammps --set study.contacts=sphere --start poured --out refused)
granum_cli_test("export: unknown path" EXIT 2 STDERR "^granum: error: --path: "
  ARGS export lammps --set study.contacts=sphere --path up --out refused)
granum_cli_test("export: a path without steps" EXIT 2 STDERR "^granum: error: path.eta_step = 0"
  ARGS export lammps --set study.contacts=sphere --path TXC --eta-step 0 --out refused)
granum_cli_test("export: folder within a file" EXIT 3 STDERR "^granum: error: isotropic\\.csv/dense-1: cannot be made"
  ARGS export lammps --set study.contacts=sphere --out isotropic.csv)

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lammps_scripts.hpp"

namespace granum::io::lammps_scripts {

namespace {

constexpr std::string_view readme =
    R"deck(LAMMPS deck of granum: equal spheres, periodic; isotropic compression, stress path, small strains.

  lmp -in in.all                 one core
  mpirun -np 16 lmp -in in.all   any number of them; the files are the same

in.all runs five parts, which can also be run one after the other, each from what the ones before left:
  in.prepare      grains.data to the first pressure                               -> prepared.restart
  in.iso          every pressure: servo, rest, snapshot                           -> states.csv
  in.probe        some of them: no sliding, rest, snapshot, G_vh, G_hh, K         -> moduli.csv
  in.path         one of them: TXC, RTXC, RTXE or TXE, snapshots at multiples of eta = q/p
                                                                                  -> path.csv, peak.csv
  in.path-probe   those snapshots: as in.probe                                    -> moduli.csv
All numbers, with their units, are in scene.lmp; -var NAME VALUE on the command line overrides one of them.

Each state leaves atoms.*.dump and contacts.*.dump with 17 digits, and state.*.restart to go on from; states
named frozen are those that were probed. The two dumps of a state together are what granum analyses:
  granum analyse atoms.STATE.dump contacts.STATE.dump
states.csv holds LAMMPS's own stresses (compression positive), moduli.csv what the probes gave.

Contacts are pair_style granular, hertz/material, tangential mindlin/force, of LAMMPS 29 Sep 2021 or later
with the package GRANULAR. z is vertical; G_vh: layers stacked along z move along x, G_hh: stacked along y.

What a run takes, estimated from small ones of LAMMPS 29 Sep 2021: 10^7 grains about 8 GB of memory over all
ranks and 30 MB for each rank; for each doubling of the pressure some 1.5e5 steps (8,700 with 2,000 grains,
growing as the edge of the box), 250 core-hours; for each state 11 GB of dumps and 3.4 GB of restart.
)deck";

constexpr std::string_view all =
    R"deck(# The whole experiment: prepare, compress, probe; then the stress path and its probes, if any.
include in.prepare
clear
include in.iso
clear
include in.probe
clear
include in.path
clear
include in.path-probe
)deck";

constexpr std::string_view prepare =
    R"deck(# From grains.data to the first pressure.
include scene.lmp
include settings.lmp
read_data grains.data
variable mu equal ${prepare_friction} # [1]
variable tolerance equal ${prepare_tolerance} # [1]
variable inertial_number equal ${iso_inertial_number} # [1]
include model.lmp
if "${start} == scattered" then "include gather.lmp"
include servo.lmp
run 0
write_restart prepared.restart
)deck";

constexpr std::string_view iso =
    R"deck(# Isotropic compression with friction through all pressures, each ending at rest.
include scene.lmp
include settings.lmp
read_restart prepared.restart
variable mu equal ${friction} # [1]
variable tolerance equal ${iso_tolerance} # [1]
variable inertial_number equal ${iso_inertial_number} # [1]
include model.lmp
print "pressure_Pa,state,step,sigma_xx_Pa,sigma_yy_Pa,sigma_zz_Pa,sigma_xy_Pa,sigma_xz_Pa,sigma_yz_Pa,&
volume_m3,unbalanced_force_ratio" file states.csv screen no
label next_pressure
include servo.lmp
include rest.lmp
variable name string ${state}
include snapshot.lmp
next pressure state
jump SELF next_pressure
)deck";

constexpr std::string_view probe =
    R"deck(# Small-strain moduli of some states of in.iso.
include scene.lmp
print "pressure_Pa,state,modulus,value_Pa,strain" file moduli.csv screen no
if "${probed_states} > 0" then "include probes.lmp"
)deck";

constexpr std::string_view settings =
    R"deck(# What must be said before there is a box.
units si
atom_style sphere
boundary p p p
newton on # each contact across a face is worked out once, with one history, and its two forces cancel
comm_modify vel yes # contacts need the velocities of their partners across processors and faces
box tilt large
neighbor $(0.3*v_radius:%.17g) bin # [m]
neigh_modify delay 0 every 1 check yes # [steps]
# Estimates at the pressure of the moment, for step, drag and servo.
variable mass equal 4/3*PI*v_radius^3*v_density # of a grain [kg]
variable mean_force equal 4*PI*v_radius^2*v_pressure/(v_coordination*v_solid_fraction) # of the contacts [N]
variable overlap equal (v_mean_force/v_hertz)^(2/3) # [m]
variable stiffness equal 1.5*v_mean_force/v_overlap # k_n = df/d(overlap) [N/m]
variable time_step equal v_time_step_share*sqrt(v_mass/v_stiffness) # [s]
variable bulk equal v_coordination*v_solid_fraction*v_stiffness/(6*PI*v_radius) # uniform strain [Pa]
variable wave_speed equal sqrt(v_relaxed_share*v_bulk/(v_solid_fraction*v_density)) # of shear [m/s]
variable drag_share equal 1 # of the drag that is critical for the longest shear wave [1]
variable drag equal v_drag_share*4*PI*v_mass*v_wave_speed/lx # [kg/s]
variable fastest_rate equal v_inertial_number/(2*v_radius)*sqrt(v_pressure/v_density) # [1/s]
variable time_by_rate equal v_pressure/(3*v_bulk*v_fastest_rate) # [s]
variable time_by_wave equal 2*lx/v_wave_speed # [s]
variable servo_time equal &
  (v_time_by_rate>v_time_by_wave)*v_time_by_rate+(v_time_by_rate<=v_time_by_wave)*v_time_by_wave # [s]
)deck";

constexpr std::string_view model =
    R"deck(# Contacts, motion and measures; pair_style takes the histories over from a restart.
pair_style granular
pair_coeff * * hertz/material ${young} ${restitution} ${poisson} &
  tangential mindlin/force ${tangential_stiffness} ${tangential_damping} ${mu} damping tsuji
timestep ${time_step}
fix motion all nve/sphere
compute stress all pressure NULL virial # of the contacts alone, compression positive [Pa]
compute torque all property/atom tqx tqy tqz # [N m]
# Unbalanced: what the contacts leave on a grain, without the drag, over the mean contact force.
variable own_force atom sqrt((fx+v_drag*vx)^2+(fy+v_drag*vy)^2+(fz+v_drag*vz)^2) # [N]
variable own_moment atom sqrt(c_torque[1]^2+c_torque[2]^2+c_torque[3]^2)/v_radius # [N]
compute own all reduce ave v_own_force v_own_moment # [N]
variable unbalanced equal (c_own[1]+c_own[2])/v_mean_force # [1]
# Rows of contacts; both with "cutoff radius", so that their numbers are equal.
compute ids all property/local patom1 patom2 ptype1 ptype2 cutoff radius
compute forces all pair/local dist force fx fy fz p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 cutoff radius
thermo 2000 # [steps]
thermo_style custom step c_stress c_stress[1] c_stress[2] c_stress[3] c_stress[4] c_stress[5] c_stress[6] &
  v_unbalanced ke vol
thermo_modify norm no format float %.9g
)deck";

constexpr std::string_view gather =
    R"deck(# Scattered grains are moved together by the box: quickly while they hardly touch, then at falling
# rates, each until half the pressure is there for a moment; then the servo works to a first tolerance. All
# this without drag: it would hold back grains that are pushed aside, and pass for pressure before they jam.
variable smaller equal (v_first_solid_fraction/v_gathered_solid_fraction)^(1/3) # of each edge [1]
variable jammed equal "c_stress > 0.5*v_pressure" # [1]
fix box all deform 1 x scale ${smaller} y scale ${smaller} z scale ${smaller} remap x
run ${gather_steps}
unfix box
label next_rate
variable inertial_number equal ${gather_inertial_number} # [1]
run $(v_gather_steps/10) # grains that were pushed into each other part
fix box all deform 1 x trate $(-v_fastest_rate:%.17g) y trate $(-v_fastest_rate:%.17g) &
  z trate $(-v_fastest_rate:%.17g) remap x
fix halt all halt 10 v_jammed > 0.5 error continue message no # asked every 10 steps
run ${servo_steps}
unfix halt
unfix box
next gather_inertial_number
jump SELF next_rate
variable inertial_number equal ${iso_inertial_number} # [1]
variable tolerance equal ${gather_tolerance} # [1]
variable drag_share equal 0 # [1]
include servo.lmp
variable drag_share equal 1 # [1]
variable tolerance equal ${prepare_tolerance} # [1]
)deck";

constexpr std::string_view servo =
    R"deck(# To the pressure, in steps that are quasi-static, until stress and forces agree.
# Positions follow the box. That is right here: a change of size leaves no tangential motion in contacts.
# Without friction a packing cannot choose its shape, and the edges keep their ratio.
timestep ${time_step}
fix drag all viscous ${drag}
if "${mu} > 0" then "variable coupling string aniso" else "variable coupling string iso"
fix servo all press/berendsen ${coupling} ${pressure} ${pressure} $(v_servo_time:%.17g) &
  modulus $(v_bulk:%.17g)
fix_modify servo press stress
variable axes_error equal &
  (abs(c_stress[1]/v_pressure-1)+abs(c_stress[2]/v_pressure-1)+abs(c_stress[3]/v_pressure-1))/3 # [1]
variable stress_error equal "(v_mu > 0)*v_axes_error + (v_mu <= 0)*abs(c_stress/v_pressure-1)" # [1]
variable arrived equal "(v_stress_error < v_tolerance) && (v_unbalanced < v_tolerance)" # [1]
fix halt all halt 100 v_arrived > 0.5 error continue message no # asked every 100 steps
run ${servo_steps}
unfix halt
unfix servo
unfix drag
)deck";

constexpr std::string_view rest =
    R"deck(# To rest at fixed box, then without any velocity: forces are those of springs alone.
# A rattler that is slowly squeezed out of its cage can keep the forces from balancing; it bears no load, and
# the number of steps is limited for that.
fix drag all viscous ${drag}
fix halt all halt 100 v_unbalanced < ${rest_tolerance} error continue message no # asked every 100 steps
run ${rest_steps}
unfix halt
unfix drag
velocity all set 0 0 0 # [m/s]
set group all omega 0 0 0 # [1/s]
run 0
)deck";

constexpr std::string_view snapshot =
    R"deck(# Grains and contacts with all digits, the stress by LAMMPS, what later parts start from. [m, N]
dump atoms all custom 1 atoms.${name}.dump id type radius x y z fx fy fz
dump_modify atoms sort id format float %.17g
dump contacts all local 1 contacts.${name}.dump index c_ids[*] c_forces[*]
dump_modify contacts format float %.17g
run 0
undump atoms
undump contacts
print "$(v_pressure:%.17g),${name},$(step),$(c_stress[1]:%.17g),$(c_stress[2]:%.17g),$(c_stress[3]:%.17g),&
$(c_stress[4]:%.17g),$(c_stress[5]:%.17g),$(c_stress[6]:%.17g),$(vol:%.17g),$(v_unbalanced:%.3g)" &
  append states.csv screen no
write_restart state.${name}.restart # after a run 0: before any run it would hold no histories
print "variable pressure delete" file state.${name}.lmp screen no
print "variable pressure string $(v_pressure:%.17g) # [Pa]" append state.${name}.lmp screen no
)deck";

constexpr std::string_view probes =
    R"deck(# Small-strain moduli of the states in probe_state: no sliding, at rest, each from that state.
label next_state
include state.${probe_state}.lmp
variable name string ${probe_state}.frozen
variable mu equal ${probe_friction} # [1]
include settings.lmp
read_restart state.${probe_state}.restart
include model.lmp
velocity all set 0 0 0 # [m/s]
set group all omega 0 0 0 # [1/s]
include rest.lmp
include snapshot.lmp
variable modulus delete
variable modulus index G_vh G_hh K
label next_modulus
clear
include settings.lmp
read_restart state.${name}.restart
change_box all triclinic
include model.lmp
include cycle.lmp
next modulus
jump SELF next_modulus
clear
next probe_state
jump SELF next_state
)deck";

constexpr std::string_view cycle =
    R"deck(# One modulus: the state at rest under +strain and under -strain, secant between the two.
variable strain equal v_probe_share*v_overlap/(2*v_radius) # [1]
include ${modulus}.lmp
variable leg equal v_strain # [1]
include leg.lmp
variable up equal $(v_answer:%.17g) # [Pa]
variable leg equal -2*v_strain # [1]
include leg.lmp
variable down equal $(v_answer:%.17g) # [Pa]
variable value equal (v_down-v_up)/(2*v_strain) # [Pa]
print "$(v_pressure:%.17g),${probe_state},${modulus},$(v_value:%.17g),$(v_strain:%.6g)" &
  append moduli.csv screen no
)deck";

constexpr std::string_view leg =
    R"deck(# The box takes the strain of the leg, and the grains move with it as a field of velocities.
# remap v and the field belong together: were positions moved instead (remap x), contacts would not feel the
# tangential part of the motion, and G would come out wrong. After the ramp the field is taken away again.
variable rate equal v_leg/(v_ramp_steps*dt) # [1/s]
variable speed string $(v_rate:%.17g)
variable third string $(v_rate/3:%.17g)
if "${modulus} == G_vh" then "fix box all deform 1 xz erate ${speed} remap v" &
elif "${modulus} == G_hh" "fix box all deform 1 xy erate ${speed} remap v" &
else "fix box all deform 1 x erate ${third} y erate ${third} z erate ${third} remap v"
velocity all set v_ux v_uy v_uz sum yes
run ${ramp_steps}
unfix box
variable rate equal -v_leg/(v_ramp_steps*dt) # [1/s]
velocity all set v_ux v_uy v_uz sum yes
include rest.lmp
)deck";

constexpr std::string_view G_vh =
    R"deck(# Layers stacked along z move along x.
variable ux atom v_rate*(z-0.5*(zlo+zhi)) # [m/s]
variable uy atom 0 # [m/s]
variable uz atom 0 # [m/s]
variable answer equal c_stress[5] # xz [Pa]
)deck";

constexpr std::string_view G_hh =
    R"deck(# Layers stacked along y move along x.
variable ux atom v_rate*(y-0.5*(ylo+yhi)) # [m/s]
variable uy atom 0 # [m/s]
variable uz atom 0 # [m/s]
variable answer equal c_stress[4] # xy [Pa]
)deck";

constexpr std::string_view K =
    R"deck(# The volume grows by the strain, a third of it along each axis.
variable ux atom v_rate*(x-0.5*(xlo+xhi))/3 # [m/s]
variable uy atom v_rate*(y-0.5*(ylo+yhi))/3 # [m/s]
variable uz atom v_rate*(z-0.5*(zlo+zhi))/3 # [m/s]
variable answer equal c_stress # mean of the three normal stresses [Pa]
)deck";

} // namespace

const std::string_view scene_head =
    R"deck(# The scene in numbers, SI. A number can be overridden: lmp -in in.all -var NAME VALUE
)deck";

const std::array<Script, 17> files{{{"README.txt", readme},
                                    {"in.all", all},
                                    {"in.prepare", prepare},
                                    {"in.iso", iso},
                                    {"in.probe", probe},
                                    {"settings.lmp", settings},
                                    {"model.lmp", model},
                                    {"gather.lmp", gather},
                                    {"servo.lmp", servo},
                                    {"rest.lmp", rest},
                                    {"snapshot.lmp", snapshot},
                                    {"probes.lmp", probes},
                                    {"cycle.lmp", cycle},
                                    {"leg.lmp", leg},
                                    {"G_vh.lmp", G_vh},
                                    {"G_hh.lmp", G_hh},
                                    {"K.lmp", K}}};

} // namespace granum::io::lammps_scripts

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lammps_scripts.hpp"

namespace granum::io::lammps_scripts {

namespace {

constexpr std::string_view path =
    R"deck(# A stress path from a state of in.iso: one stress is driven at constant inertial number, one held.
include scene.lmp
if "x${path} == xnone" then "jump SELF end"
include state.${path_start}.lmp
variable held equal ${pressure} # [Pa]
variable mu equal ${friction} # [1]
include settings.lmp
read_restart state.${path_start}.restart
include model.lmp
include path_measures.lmp
include path_${path_drives}.lmp
print "step,sigma_x_Pa,sigma_y_Pa,sigma_z_Pa,eta,axial_strain,volumetric_strain" file path.csv screen no
run 0
label next_segment
include path_segment.lmp
if "$(v_eta_reached) >= $(v_eta_next)" then "include path_snapshot.lmp"
if "$(abs(v_axial_strain)) < ${path_largest_strain}" then "jump SELF next_segment"
print "variable probe_state delete" file path_states.lmp screen no
print "variable probe_state index ${path_states}" append path_states.lmp screen no
print "variable probed_states delete" append path_states.lmp screen no
print "variable probed_states string $(v_eta_count-1)" append path_states.lmp screen no
print "path,eta,friction_angle_deg,axial_strain" file peak.csv screen no
print "${path},${peak_eta},$(v_peak_angle:%.6g),${peak_strain}" append peak.csv
label end
)deck";

constexpr std::string_view path_probe =
    R"deck(# Small-strain moduli of the states of in.path.
include scene.lmp
if "x${path} == xnone" then "jump SELF end"
include path_states.lmp
if "${probed_states} > 0" then "include probes.lmp"
label end
)deck";

constexpr std::string_view path_measures =
    R"deck(# Where a path stands, and its servos. Strains: logarithmic, from its start, compression positive.
variable start_height equal $(lz:%.17g) # [m]
variable start_volume equal $(vol:%.17g) # [m^3]
variable axial_strain equal -ln(lz/v_start_height) # [1]
variable volumetric_strain equal -ln(vol/v_start_volume) # [1]
variable horizontal equal (c_stress[1]+c_stress[2])/2 # [Pa]
variable eta equal 3*(c_stress[3]-v_horizontal)/(c_stress[3]+2*v_horizontal) # q/p [1]
variable eta_reached equal v_path_eta_sign*v_eta # [1]
variable eta_count string 1
variable eta_next equal v_eta_count*v_path_eta_step # [1]
variable path_states string none
# Rates of strain [1/s]: of the path, and of two servos a and b, proportional and integral. modulus is that of
# uniform strain, near that for one axis; a gap is closed in about two segments.
variable driven equal v_path_sense*v_shear_inertial_number/(2*v_radius)*sqrt(v_pressure/v_density) # [1/s]
variable limit equal 3*abs(v_driven) # [1/s]
variable closing equal 3*v_bulk*2*v_segment_steps*dt # [Pa s]
variable integral_a string 0
variable integral_b string 0
variable wanted_a equal v_gap_a/v_closing+v_integral_a # [1/s]
variable wanted_b equal v_gap_b/v_closing+v_integral_b # [1/s]
variable servo_a equal &
  (abs(v_wanted_a)<v_limit)*v_wanted_a+((v_wanted_a>=v_limit)-(v_wanted_a<=-v_limit))*v_limit # [1/s]
variable servo_b equal &
  (abs(v_wanted_b)<v_limit)*v_wanted_b+((v_wanted_b>=v_limit)-(v_wanted_b<=-v_limit))*v_limit # [1/s]
# The integrals learn in twenty segments, and not while the servo is at its limit.
variable learnt_a equal &
  v_integral_a+((abs(v_wanted_a)<v_limit)||(v_wanted_a*v_gap_a<0))*v_gap_a/v_closing/20 # [1/s]
variable learnt_b equal &
  v_integral_b+((abs(v_wanted_b)<v_limit)||(v_wanted_b*v_gap_b<0))*v_gap_b/v_closing/20 # [1/s]
# Rates of the segment under way, and the change of the field of velocities at its beginning.
variable now_x string 0
variable now_y string 0
variable now_z string 0
variable kick_x atom -(v_rate_x-v_now_x)*(x-0.5*(xlo+xhi)) # [m/s]
variable kick_y atom -(v_rate_y-v_now_y)*(y-0.5*(ylo+yhi)) # [m/s]
variable kick_z atom -(v_rate_z-v_now_z)*(z-0.5*(zlo+zhi)) # [m/s]
# The largest stress ratio so far.
variable peak_eta string 0
variable peak_strain string 0
variable peak_sine equal &
  abs(3*v_peak_eta)/(6+v_peak_eta) # (s1-s3)/(s1+s3) of axisymmetric stress, compression and extension [1]
variable peak_angle equal asin(v_peak_sine)*180/PI # [degrees]
)deck";

constexpr std::string_view path_axial =
    R"deck(# The height is driven; both horizontal stresses are held.
variable gap_a equal v_held-c_stress[1] # [Pa]
variable gap_b equal v_held-c_stress[2] # [Pa]
variable rate_x equal v_servo_a # [1/s]
variable rate_y equal v_servo_b # [1/s]
variable rate_z equal v_driven # [1/s]
)deck";

constexpr std::string_view path_lateral =
    R"deck(# Both widths are driven by half the rate; the vertical stress is held, the other two kept equal.
variable gap_a equal v_held-c_stress[3] # [Pa]
variable gap_b equal (c_stress[2]-c_stress[1])/2 # [Pa]
variable rate_x equal v_driven/2+v_servo_b # [1/s]
variable rate_y equal v_driven/2-v_servo_b # [1/s]
variable rate_z equal v_servo_a # [1/s]
)deck";

constexpr std::string_view path_segment =
    R"deck(# Rates of strain for the stresses of the moment, for some steps. Their change goes to the
# box and, as a field of velocities, to the grains at once (remap v): contacts feel all of the motion.
variable pressure string $(c_stress:%.17g) # [Pa]
timestep ${time_step}
velocity all set v_kick_x v_kick_y v_kick_z sum yes
variable next_x string $(v_rate_x:%.17g)
variable next_y string $(v_rate_y:%.17g)
variable next_z string $(v_rate_z:%.17g)
variable next_a string $(v_learnt_a:%.17g)
variable next_b string $(v_learnt_b:%.17g)
variable now_x string ${next_x}
variable now_y string ${next_y}
variable now_z string ${next_z}
variable integral_a string ${next_a}
variable integral_b string ${next_b}
fix box all deform 1 x erate $(-v_now_x:%.17g) y erate $(-v_now_y:%.17g) z erate $(-v_now_z:%.17g) remap v
run ${segment_steps} post no
unfix box
print "$(step),$(c_stress[1]:%.6g),$(c_stress[2]:%.6g),$(c_stress[3]:%.6g),$(v_eta:%.6g),&
$(v_axial_strain:%.6g),$(v_volumetric_strain:%.6g)" append path.csv screen no
if "$(abs(v_eta)) > $(abs(v_peak_eta))" then &
  "variable peak_strain string $(v_axial_strain:%.6g)" "variable peak_eta string $(v_eta:%.6g)"
)deck";

constexpr std::string_view path_snapshot =
    R"deck(# eta has passed a multiple of its step for the first time.
variable name string ${path}.$(v_eta_next:%.4g)
include snapshot.lmp
if "${eta_count} == 1" then "variable path_states string ${name}" &
else "variable path_states string '${path_states} ${name}'"
variable eta_count string $(v_eta_count+1)
run 0 # the stress of the moment once more, for the next segment
)deck";

} // namespace

const std::array<Script, 7> path_files{{{"in.path", path},
                                        {"in.path-probe", path_probe},
                                        {"path_measures.lmp", path_measures},
                                        {"path_axial.lmp", path_axial},
                                        {"path_lateral.lmp", path_lateral},
                                        {"path_segment.lmp", path_segment},
                                        {"path_snapshot.lmp", path_snapshot}}};

} // namespace granum::io::lammps_scripts

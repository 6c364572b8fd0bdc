// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/state_bytes.hpp>

namespace granum::dem {

void save_state(ByteWriter& to, const State& state) {
  to.put(state.cell);
  to.put(state.radius);
  to.put_all(state.position);
  to.put_all(state.velocity);
  to.put_all(state.angular_velocity);
  to.put_all(state.history);
  to.put(static_cast<std::uint64_t>(state.walls.has_value()));
  if (state.walls) {
    to.put(state.walls->friction_coefficient);
    to.put_all(state.walls->history);
  }
}

State load_state(ByteReader& from) {
  State state;
  state.cell = from.get<Mat3>();
  state.radius = from.get<double>();
  state.position = from.get_all<Vec3>();
  state.velocity = from.get_all<Vec3>();
  state.angular_velocity = from.get_all<Vec3>();
  state.history = from.get_all<ContactHistory>();
  if (from.get<std::uint64_t>() != 0) {
    state.walls.emplace();
    state.walls->friction_coefficient = from.get<double>();
    state.walls->history = from.get_all<WallHistory>();
  }
  return state;
}

} // namespace granum::dem

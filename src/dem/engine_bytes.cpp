// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <granum/core/bytes.hpp>
#include <granum/dem/specimen.hpp>

#include "engine_data.hpp"

namespace granum::dem {

namespace {

/// The numbers that determine the forces; materials with the same numbers give the same bits.
std::vector<double> fingerprint(const Material& material) {
  std::vector<double> numbers = material.law.numbers();
  numbers.insert(numbers.end(), {material.tangential_ratio, material.friction_coefficient, material.density});
  return numbers;
}

/// Scalars of Engine::Data, listed once for writing and reading.
template <class Data, class Visit>
void each_scalar(Data& d, const Visit& visit) {
  visit(d.gradient);
  visit(d.dt);
  visit(d.time_step_fraction);
  visit(d.fixed_damping);
  visit(d.damping);
  visit(d.descends);
  visit(d.mixing);
  visit(d.travelled);
  visit(d.strained);
  visit(d.motion);
  visit(d.stiffest);
  visit(d.stiffest_chosen);
  visit(d.contacts_chosen);
  visit(d.figures);
  visit(d.steps);
}

/// Whether all indices are valid for this number of grains, with pairs as from neighbour_pairs.
bool are_pairs(const std::vector<Pair>& pairs, std::size_t grains) {
  const auto impossible = [&](const Pair& p) {
    return p.i >= p.j || p.j >= grains || p.image >= image_count;
  };
  const auto before = [](const Pair& a, const Pair& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); };
  return std::none_of(pairs.begin(), pairs.end(), impossible) &&
         std::is_sorted(pairs.begin(), pairs.end(), before);
}

/// Replaces a list by one of the same length.
template <class T>
void take(ByteReader& from, std::vector<T>& list) {
  std::vector<T> read = from.get_all<T>();
  if (read.size() != list.size())
    from.fail("contains a list of " + std::to_string(read.size()) + " where its engine has one of " +
              std::to_string(list.size()));
  list = std::move(read);
}

} // namespace

void Engine::save(ByteWriter& to) const {
  const Data& d = *data_;
  for (const double number : fingerprint(d.material))
    to.put(number);
  save_specimen(to, state());
  to.put_all(d.order);
  to.put_all(d.list.pairs());
  to.put_all(d.grains.row);
  to.put_all(d.grains.spin_y);
  to.put_all(d.memory);
  to.put_all(d.load);
  if (d.walls)
    d.walls->save(to);
  each_scalar(d, [&](const auto& value) { to.put(value); });
}

Engine Engine::load(ByteReader& from, const Material& material) {
  for (const double number : fingerprint(material))
    if (from.get<double>() != number)
      from.fail("was written for grains of another material or contact law");
  Specimen state = load_specimen(from);
  std::vector<std::uint32_t> order = from.get_all<std::uint32_t>();
  if (!is_order(order, state.grain_count()))
    from.fail("contains an impossible order of its grains");
  Engine engine(std::make_unique<Data>(std::move(state), material, std::move(order)));
  Data& d = *engine.data_;
  std::vector<Pair> pairs = from.get_all<Pair>();
  if (!are_pairs(pairs, d.grains.size()))
    from.fail("contains impossible pairs of its grains");
  d.list.restore(std::move(pairs));
  d.lay_out();
  if (d.tangential)
    d.memory.resize(d.parts.pairs.size() / block_size);
  take(from, d.grains.row);
  take(from, d.grains.spin_y);
  take(from, d.memory);
  take(from, d.load);
  if (d.walls)
    d.walls->load(from, d.grains.size());
  each_scalar(d, [&](auto& value) { value = from.get<std::remove_reference_t<decltype(value)>>(); });
  if (!(d.dt > 0 && d.time_step_fraction > 0))
    from.fail("contains an impossible time step");
  return engine;
}

} // namespace granum::dem

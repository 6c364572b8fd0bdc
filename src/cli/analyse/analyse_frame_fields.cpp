// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analyse_fields.hpp"
#include "analyse_stress.hpp"

namespace granum::cli {

namespace {

using analysis::Counts;
using analysis::Measurement;
using io::ShownColumn;

using FrameFields = io::Columns<FrameAnswer>;

/// Access to an optional part of a frame.
template <class Part>
auto optional_part(std::optional<Part> Measurement::*member) {
  return [member](const FrameAnswer& frame) {
    const std::optional<Part>& part = frame.measured.packing.*member;
    return part ? &*part : nullptr;
  };
}

auto notes_of_reader(bool missing) {
  return [missing](const FrameAnswer& frame) {
    std::vector<std::string> texts;
    for (const io::ImportNote& note : frame.read)
      if (says_what_is_missing(note.finding) == missing)
        texts.push_back(note.text);
    return texts;
  };
}

void add_state(FrameFields& to) {
  const auto of_grains = [](auto Measurement::*of) {
    return [of](const FrameAnswer& f) {
      return f.measured.packing.counts.grains > 0 ? &(f.measured.packing.*of) : nullptr;
    };
  };
  to = {{"file", "file", &FrameAnswer::file},
        {"frame", "frame", &FrameAnswer::number, ShownColumn{.heading = "frame", .width = 5}},
        {"step", "step", [](const FrameAnswer& f) { return f.measured.step; },
         ShownColumn{.heading = "step", .width = 9}},
        {"time_s", "time", io::or_null([](const FrameAnswer& f) { return f.measured.time; })},
        {"", "found", notes_of_reader(false)},
        {"", "not_in_the_files", notes_of_reader(true)}};
  io::add_part(to, packing_fields(), [](const FrameAnswer& f) {
    return f.measured.packing.counts.grains > 0 ? &f.measured.packing : nullptr;
  });
  for (const io::Column<Counts>& field : contact_count_fields())
    to.push_back({field.heading, "counts/" + field.key,
                  [of = field.of](const FrameAnswer& f) {
                    const Counts& counts = f.measured.packing.counts;
                    if (counts.grains == 0)
                      return io::Value();
                    return f.measured.contacts_known ? of(counts) : io::Value(nullptr);
                  },
                  field.shown});
  io::add_part(to, grain_count_fields(), of_grains(&Measurement::counts), "counts/");
}

void add_forces(FrameFields& to) {
  io::add_part(to, fabric_fields(), optional_part(&Measurement::fabric), "fabric/");
  io::add_part(to, stress_fields(), optional_part(&Measurement::stress), "stress/");
  to.emplace_back("p_by_code_Pa", "", studies::mean_code_stress);
  for (std::size_t k = 0; k < std::size(studies::stress_names); ++k) {
    const std::string name = studies::stress_names[k];
    to.emplace_back("", "stress/by_code/" + name, [k](const FrameAnswer& f) {
      return f.code_stress ? std::optional((*f.code_stress)[k]) : std::nullopt;
    });
    to.emplace_back("", "stress/relative_difference/" + name, [k](const FrameAnswer& f) {
      return f.code_stress
                 ? io::or_null([k](const FrameAnswer& g) { return studies::stress_differences(g)[k]; })(f)
                 : io::Value();
    });
  }
  io::add_part(to, force_fields(), optional_part(&Measurement::forces), "forces/");
  io::add_part(
      to, law_fields(),
      [](const FrameAnswer& f) {
        const auto& check = f.measured.packing.law_check;
        return check && check->contacts > 0 ? &*check : nullptr;
      },
      "contact_law/");
}

void add_rungs(FrameFields& to, const std::vector<RungResult>& rungs) {
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    io::Columns<RungResult> fields = rung_fields();
    for (io::Column<RungResult>& field : fields) {
      const bool relaxed = rungs[k].name == studies::relaxed_name();
      field.shown.reset();
      if (field.heading == "G" && (relaxed || rungs[k].name == network_name()))
        field.shown = ShownColumn{
            .heading = relaxed ? "G rung 3" : "G network", .width = 10, .unit = 1e6, .absent = "-"};
      if (!field.heading.empty())
        field.heading += "_" + rungs[k].name + "_Pa";
    }
    io::add_part(
        to, fields, [k](const FrameAnswer& f) { return k < f.rungs.size() ? &f.rungs[k] : nullptr; },
        "moduli/" + rungs[k].name + "/");
  }
}

/// "probes/G_vh/value" and so on, for the probed moduli.
void add_probes(FrameFields& to) {
  for (const Probing& modulus : probings()) {
    const std::string name = modulus.name;
    const auto of = [name](const FrameAnswer& frame) {
      const auto is = [&](const studies::ProbedModulus& probe) { return probe.modulus == name; };
      const auto found = std::find_if(frame.probes.begin(), frame.probes.end(), is);
      return found == frame.probes.end() ? nullptr : &*found;
    };
    io::add_part<FrameAnswer, studies::ProbedModulus>(
        to,
        {{"", "value", &studies::ProbedModulus::value},
         {"", "network_over_probe", &studies::ProbedModulus::network_over_probe}},
        of, "probes/" + name + "/");
  }
}

/// The network, and quantities derived from both of its matrices, "relaxed_E_1_Pa" and so on.
void add_network(FrameFields& to, const FrameAnswer& like) {
  io::add_part(to, network_fields(), optional_part(&Measurement::network), "network/");
  const std::vector<NamedMatrix> matrices = network_matrices(like);
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    const std::string name = matrices[k].name;
    for (const auto* part : {&matrix_fields(), &wave_fields()})
      for (const io::Column<NamedMatrix>& field : *part)
        to.emplace_back(field.heading.empty() ? "" : name + "_" + field.heading,
                        field.key.empty() ? "" : "network/" + name + "/" + field.key,
                        [k, of = field.of](const FrameAnswer& frame) {
                          const std::vector<NamedMatrix> its = network_matrices(frame);
                          return k < its.size() ? of(its[k]) : io::Value();
                        });
  }
}

} // namespace

FrameFields frame_fields(const FrameAnswer& like) {
  FrameFields fields;
  add_state(fields);
  for (const auto& [key, part] :
       {std::pair{"window/low", &analysis::Window::low}, {"window/high", &analysis::Window::high}})
    fields.emplace_back("", key, [part = part](const FrameAnswer& f) {
      return f.window && f.measured.packing.interior ? std::optional(values((*f.window).*part))
                                                     : std::nullopt;
    });
  io::add_part(
      fields, window_fields(),
      [](const FrameAnswer& f) {
        const auto& inside = f.measured.packing.interior;
        return f.window && inside ? &*inside : nullptr;
      },
      "window/");
  for (io::Column<FrameAnswer>& field : fields)
    if (field.key.starts_with("window/"))
      field.shown.reset();
  add_forces(fields);
  io::add_part<FrameAnswer, contact::GrainMaterial>(
      fields,
      {{"", "shear_modulus", &contact::GrainMaterial::shear_modulus},
       {"", "poisson_ratio", &contact::GrainMaterial::poisson_ratio}},
      optional_part(&Measurement::grain), "grain/");
  add_rungs(fields, like.rungs);
  add_probes(fields);
  add_network(fields, like);
  fields.emplace_back("", "", studies::network_over_relaxed,
                      ShownColumn{.heading = "ratio", .width = 7, .digits = 3, .fixed = true, .absent = "-"});
  fields.emplace_back("", "bulk_density",
                      [](const FrameAnswer& f) { return f.measured.packing.bulk_density; });
  fields.emplace_back("", "notes", [](const FrameAnswer& f) { return f.measured.packing.notes; });
  fields.emplace_back("", "warnings", [](const FrameAnswer& f) { return f.measured.warnings; });
  fields.emplace_back("", "seconds", &FrameAnswer::seconds);
  return fields;
}

} // namespace granum::cli

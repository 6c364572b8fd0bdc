// SPDX-License-Identifier: GPL-3.0-or-later
// effective::slip_loss beside the recorded cycles.
//
//     slip_onset_report table states.csv      as in README.md
//     slip_onset_report check states.csv      exit code 0 if the closed form holds where README.md says so
//     slip_onset_report picture states.csv    the same as SVG
//     slip_onset_report loops loops.csv       damping of closed loops beside Masing's rule
#include <granum/effective/slip.hpp>
#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "states.hpp"

namespace {

using namespace granum;

std::string name_of(const Entry& row) {
  return row.text("density") + ", " + short_text(row("p_Pa") / 1e3) + " kPa #" + row.text("seed");
}

/// A specimen and its cycles.
struct Specimen {
  std::string name;
  bool dense = true;
  double z_star = 0;
  effective::SlipOnset onset;
  struct Cycle {
    double strain = 0, third = 0, tenth = 0; ///< G over G of a small probe
  };
  std::vector<Cycle> cycles;

  [[nodiscard]] double closed_form(double strain) const {
    return 1 - effective::slip_loss(onset, strain, effective::ContactSlip::sliding);
  }
};

std::vector<Specimen> read(const std::string& path) {
  std::vector<Specimen> all;
  for (const Entry& row : read_record(path)) {
    if (all.empty() || all.back().name != name_of(row)) {
      const effective::State state{.law = contact::PowerLaw::sphere(slip_onset::quartz, slip_onset::radius),
                                   .tangential_ratio = slip_onset::tangential_ratio(),
                                   .radius = slip_onset::radius,
                                   .void_ratio = row("e"),
                                   .coordination_number = row("C_n"),
                                   .stress_v = row("p_Pa"),
                                   .stress_h = row("p_Pa")};
      all.push_back({.name = name_of(row),
                     .dense = row.text("density") == "dense",
                     .z_star = row("z_star"),
                     .onset = effective::slip_onset(state, row("z_star"), slip_onset::friction),
                     .cycles = {}});
    }
    const double G0 = row("G0_Pa");
    all.back().cycles.push_back({row("strain_1"), row("G_cycle_3_Pa") / G0, row("G_cycle_10_Pa") / G0});
  }
  return all;
}

/// Largest distance of the closed form from a cycle's G, over G0, of cycles that lost 5 % at most.
double worst(const Specimen& s, double Specimen::Cycle::*cycle) {
  double most = 0;
  for (const Specimen::Cycle& at : s.cycles)
    if (at.*cycle >= 1 - effective::largest_slip_loss)
      most = std::max(most, std::abs(at.*cycle - s.closed_form(at.strain)));
  return most;
}

/// Where the third cycle has a share of G0, in equal shares of ln strain between the amplitudes.
double by_cycles(const Specimen& s, double level) {
  for (std::size_t k = 1; k < s.cycles.size(); ++k) {
    const Specimen::Cycle &above = s.cycles[k - 1], &below = s.cycles[k];
    if (above.third > level && below.third <= level)
      return above.strain *
             std::pow(below.strain / above.strain, (above.third - level) / (above.third - below.third));
  }
  return NAN;
}
double by_closed_form(const Specimen& s, double level) {
  double low = 1e-7, high = 1e-2;
  while (high / low > 1 + 1e-6) {
    const double middle = std::sqrt(low * high);
    (s.closed_form(middle) > level ? low : high) = middle;
  }
  return low;
}

void print_table(const std::vector<Specimen>& all) {
  std::printf(
      "| specimen | z* | reference strain | worst of 3rd, 10th cycle to a loss of 5 %% | strain of 1 %% "
      "loss: DEM, closed form | of 5 %% |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const Specimen& s : all)
    std::printf("| %s | %.2f | %.2e | %.2f %%, %.2f %% | %.1e, %.1e | %.1e, %.1e |\n", s.name.c_str(),
                s.z_star, s.onset.reference_strain, 100 * worst(s, &Specimen::Cycle::third),
                100 * worst(s, &Specimen::Cycle::tenth), by_cycles(s, 0.99), by_closed_form(s, 0.99),
                by_cycles(s, 0.95), by_closed_form(s, 0.95));
}

int check(const std::vector<Specimen>& all) {
  Claims claims;
  claims.require(all.size() >= 5, "five specimens and more");
  for (const Specimen& s : all) {
    const double third = worst(s, &Specimen::Cycle::third);
    if (s.dense) {
      claims.require(third <= 0.01,
                     s.name + ": within 1 % of G0 to a loss of 5 %: " + short_text(100 * third, 2) + " %");
      claims.require(by_cycles(s, 0.95) < s.cycles.back().strain,
                     s.name + ": the cycles go on to a loss of 5 %");
    } else {
      const double ratio = by_cycles(s, 0.95) / by_closed_form(s, 0.95);
      claims.require(ratio < 0.5, s.name + ": DEM has lost 5 % before the closed form says so, at " +
                                      short_text(ratio, 2) + " of its strain");
    }
  }
  return claims.exit_code();
}

plot::Chart picture(const std::vector<Specimen>& all) {
  plot::Chart chart{
      .title = "Shear modulus over strain of quartz spheres that slide, third cycle",
      .x = {.title = "shear strain over the reference strain", .scale = plot::Scale::logarithmic},
      .y = {.title = "G/G\u2080"},
      .finding = "In dense packings cycles and closed form lie on each other to a loss of 5 %; loose "
                 "ones soften at a smaller strain."};
  for (const bool dense : {true, false}) {
    const auto shown = std::ranges::find(all, dense, &Specimen::dense);
    plot::Series& line = chart.series.emplace_back();
    line.name = std::string(dense ? "dense" : "loose") + ", closed form";
    line.mark = plot::Mark::line;
    line.style = dense ? 0U : 1U;
    line.colour = plot::Colour::closed_form;
    for (double y = 0.02; y < 4; y *= 1.05)
      line.add(y, shown->closed_form(y * shown->onset.reference_strain));
  }
  std::size_t style = 0;
  for (const Specimen& s : all) {
    plot::Series& points = chart.series.emplace_back();
    points.name = s.name;
    points.mark = plot::Mark::marker;
    points.style = style++;
    points.colour = s.dense ? plot::Colour::vertical : plot::Colour::horizontal;
    for (const Specimen::Cycle& at : s.cycles)
      if (at.third > 0.75)
        points.add(at.strain / s.onset.reference_strain, at.third);
  }
  return chart;
}

// ---- loops

/// The loops of one specimen after so many cycles, by amplitude.
struct Loops {
  std::string specimen;
  int cycle = 0;
  struct Loop {
    double strain = 0, loss = 0, damping = 0;
    double masing = 0; ///< D of a loop whose branches are the curve of G over strain, twice as large
  };
  std::vector<Loop> loops;
};

/// D = (2/pi) (2 W/(tau gamma) - 1), W the area below tau = G0 gamma (1 - loss), whose loss is a power of the
/// strain between two amplitudes.
void add_masing(std::vector<Loops::Loop>& loops) {
  double lost = 0; // integral of loss times strain
  for (std::size_t k = 0; k < loops.size(); ++k) {
    Loops::Loop& at = loops[k];
    const double here = at.loss * at.strain * at.strain;
    if (k == 0) {
      lost = here / 3;
    } else {
      const Loops::Loop& before = loops[k - 1];
      const double power = std::log(at.loss / before.loss) / std::log(at.strain / before.strain);
      lost += (here - before.loss * before.strain * before.strain) / (power + 2);
    }
    at.masing = 2 / std::numbers::pi *
                ((at.strain * at.strain - 2 * lost) / (at.strain * at.strain * (1 - at.loss)) - 1);
  }
}

std::vector<Loops> read_loops(const std::string& path) {
  std::vector<Loops> all;
  for (const int cycle : {3, 10})
    for (const Entry& row : read_record(path)) {
      if (std::lround(row("cycle")) != cycle)
        continue;
      if (all.empty() || all.back().specimen != name_of(row) || all.back().cycle != cycle)
        all.push_back({.specimen = name_of(row), .cycle = cycle, .loops = {}});
      all.back().loops.push_back({.strain = row("strain_1"),
                                  .loss = std::max(1 - row("G_Pa") / row("G0_Pa"), 1e-5),
                                  .damping = row("D")});
    }
  for (Loops& of : all)
    add_masing(of.loops);
  return all;
}

/// A ratio to the loss where that is `level`, between two amplitudes.
double at_loss(const Loops& of, double level, double Loops::Loop::*value) {
  for (std::size_t k = 1; k < of.loops.size(); ++k) {
    const Loops::Loop &a = of.loops[k - 1], &b = of.loops[k];
    if (a.loss < level && b.loss >= level)
      return std::lerp(a.*value / a.loss, b.*value / b.loss, (level - a.loss) / (b.loss - a.loss));
  }
  return NAN;
}

void print_loops(const std::vector<Loops>& all) {
  std::printf("| specimen | cycle | D over the loss of G, at 1 %% | by Masing | at 3 %% | by Masing |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const Loops& of : all)
    std::printf("| %s | %d | %.2f | %.2f | %.2f | %.2f |\n", of.specimen.c_str(), of.cycle,
                at_loss(of, 0.01, &Loops::Loop::damping), at_loss(of, 0.01, &Loops::Loop::masing),
                at_loss(of, 0.03, &Loops::Loop::damping), at_loss(of, 0.03, &Loops::Loop::masing));
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {
          {"table", "states.csv", [](const Arguments& files) { print_table(read(files[0])); }},
          {"check", "states.csv", [](const Arguments& files) { return check(read(files[0])); }},
          {"picture", "states.csv",
           [](const Arguments& files) { std::printf("%s", plot::svg(picture(read(files[0]))).c_str()); }},
          {"loops", "loops.csv", [](const Arguments& files) { print_loops(read_loops(files[0])); }},
      });
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>

#include <granum/core/text.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "studies/scene/scene_builder.hpp"
#include "studies/verify/findings.hpp"
#include "studies/verify/study.hpp"
#include "studies/verify/tables.hpp"

namespace granum::python {

namespace {

using studies::Scene;

// ---- scenes

/// A name of a key and its text, as --set takes them.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// The scene of a study.
Scene scene_of(const Settings& settings) {
  studies::SceneBuilder builder(studies::SceneCommand::verify, Scene{});
  for (const auto& [name, text] : settings)
    builder.set_listed(name, text);
  return builder.finished();
}

/// A number in SI as the text of a key.
std::string text_in_si(const std::string& name, double value) {
  return exact_text(value) + std::string(si_symbol(studies::scene_key(name).dimension));
}

// ---- running

/// The progress of a study.
struct Study {
  Scene scene;
  std::vector<studies::SpecimenResult> specimens;
};

/// Runs a study in another thread, while this one handles Ctrl-C and reports the progress.
class Run {
 public:
  Run(const Scene& scene, py::object progress) : scene_(scene), progress_(std::move(progress)) {}

  std::vector<studies::SpecimenResult> result() {
    std::future<std::vector<studies::SpecimenResult>> work;
    {
      const py::gil_scoped_release unlocked;
      work = std::async(std::launch::async, [this] {
        return studies::run_study(
            scene_, {.report = [this](const studies::Progress& p) { note(p); }, .stop = &stop_});
      });
    }
    while (!finished(work))
      listen();
    listen(); // report the last progress
    return work.get();
  }

 private:
  static bool finished(const std::future<std::vector<studies::SpecimenResult>>& work) {
    const py::gil_scoped_release unlocked;
    return work.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready;
  }
  void note(const studies::Progress& progress) {
    const std::scoped_lock lock(mutex_);
    latest_ = progress;
  }
  /// A pending exception of the interpreter is raised by the caller after the study has ended.
  void listen() {
    if (stop_)
      return;
    std::optional<studies::Progress> latest;
    {
      const std::scoped_lock lock(mutex_);
      latest.swap(latest_);
    }
    if (PyErr_CheckSignals() != 0) {
      stop_ = true;
      return;
    }
    if (!latest || progress_.is_none())
      return;
    try {
      progress_(latest->done, latest->what);
    } catch (py::error_already_set& error) {
      error.restore();
      stop_ = true;
    }
  }

  const Scene& scene_;
  py::object progress_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::optional<studies::Progress> latest_;
};

/// Attaches the finished part of a study to a pending exception of the interpreter.
[[noreturn]] void raise_with(Study study) {
  py::error_already_set error; // takes the pending one
  error.value().attr("study") = py::cast(std::move(study));
  throw error;
}

Study verify(const Settings& settings, const py::object& progress) {
  Study study{scene_of(settings), {}};
  study.specimens = Run(study.scene, progress).result();
  if (PyErr_Occurred() != nullptr)
    raise_with(std::move(study));
  return study;
}

// ---- tables

/// The columns of rows, by `name_of` a column: texts as a list, numbers as an array with NaN for empty
/// values; errors are in a separate array.
template <class Row, class NameOf>
void put_columns(py::dict& out, const io::Columns<Row>& columns, const std::vector<const Row*>& rows,
                 const NameOf& name_of) {
  for (const io::Column<Row>& column : columns) {
    if (name_of(column).empty())
      continue;
    const auto numbers = [&](const auto& of) {
      py::array_t<double> array(static_cast<py::ssize_t>(rows.size()));
      std::transform(rows.begin(), rows.end(), array.mutable_data(),
                     [&](const Row* row) { return of(column.of(*row)); });
      return array;
    };
    const py::str name(name_of(column));
    if (!rows.empty() && std::holds_alternative<std::string>(column.of(*rows.front()))) {
      py::list texts;
      for (const Row* row : rows)
        texts.append(std::get<std::string>(column.of(*row)));
      out[name] = texts;
      continue;
    }
    out[name] = numbers([&](const io::Value& value) { return io::number_of(value).value_or(nan); });
    if (column.has_error)
      out[py::str(name_of(column) + "_error")] = numbers([&](const io::Value& value) {
        const auto* measured = std::get_if<Measured>(&value);
        return measured == nullptr ? nan : measured->standard_error;
      });
  }
}

py::dict states(const Study& study) {
  py::dict out;
  py::list contact, density, seed;
  std::vector<const studies::CompressedState*> rows;
  for (const studies::SpecimenResult& specimen : study.specimens)
    for (const studies::CompressedState& state : specimen.states) {
      contact.append(std::string(contact::name(specimen.contact)));
      density.append(std::string(studies::name(specimen.density)));
      seed.append(specimen.seed);
      rows.push_back(&state);
    }
  out["contact"] = contact;
  out["density"] = density;
  out["seed"] = seed;
  put_columns(out, studies::state_columns(), rows, [](const auto& column) { return column.heading; });
  return out;
}

py::dict exponents_table(const Study& study) {
  const std::vector<studies::ExponentRow> rows = studies::exponents(study.scene, study.specimens);
  std::vector<const studies::ExponentRow*> all;
  for (const studies::ExponentRow& row : rows)
    all.push_back(&row);
  py::dict out;
  put_columns(out, studies::exponent_columns(), all, [](const auto& column) { return column.key; });
  return out;
}

std::vector<std::string> failures(const Study& study) {
  std::vector<std::string> out;
  for (const studies::SpecimenResult& specimen : study.specimens)
    if (!specimen.failure.empty())
      out.push_back(std::string(contact::name(specimen.contact)) + ", " +
                    std::string(studies::name(specimen.density)) + ", seed " + std::to_string(specimen.seed) +
                    ": " + specimen.failure);
  return out;
}

/// States, exponents and verdicts, as the program has them on its screen.
std::string study_text(const Study& study) {
  std::string out;
  for (const studies::SpecimenResult& specimen : study.specimens)
    out += studies::title(specimen) + "\n" + io::table_text(studies::state_columns(), specimen.states) + "\n";
  out += "s of G ~ p^s, +- standard error\n" +
         io::table_text(studies::exponent_columns(), studies::exponents(study.scene, study.specimens)) + "\n";
  for (const studies::Verdict& verdict : studies::verdicts(study.scene, study.specimens))
    out += std::string(studies::word_of(verdict)) + "  " + verdict.claim + ": " + verdict.measured + "\n";
  return out;
}

} // namespace

void bind_studies(py::module_& module) {
  ResultClass<studies::Verdict>(module, "Verdict", "A claim, and whether the study confirms it.")
      .show("claim", "The claim.", &studies::Verdict::claim)
      .show("holds", "Whether it is confirmed.", &studies::Verdict::holds)
      .show("measured", "The result, as text.", &studies::Verdict::measured)
      .show("decided", "Whether the result is a standard error or more from the limit of the claim.",
            &studies::Verdict::decided)
      .def("__repr__", [](const studies::Verdict& v) {
        return std::string("<") + studies::word_of(v) + ": " + v.claim + ": " + v.measured + ">";
      });
  ResultClass<Study>(module, "Study", "Results of verify: closed form, network and probe.")
      .show("states", "All states, a dict of columns with units in their names, as in states.csv.", &states)
      .show("exponents", "s of G ~ p^s by closed forms, network and probe, a dict of columns.",
            &exponents_table)
      .show("verdicts", "The verdict on each claim for which the study has data.",
            [](const Study& study) { return studies::verdicts(study.scene, study.specimens); })
      .show("failures", "Messages for specimens that failed or were stopped; empty if all ran.", &failures)
      .def("__str__", &study_text);
  module.def("_verify", &verify, py::arg("settings"), py::arg("progress"));
  module.def("_text_in_si", &text_in_si, py::arg("name"), py::arg("value"));
}

} // namespace granum::python

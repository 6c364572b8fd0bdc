// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome_text.hpp"

#include <exception>
#include <new>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>

namespace granum::studies {

std::string words(dem::Outcome outcome) {
  switch (outcome) {
  case dem::Outcome::converged:
    return "converged";
  case dem::Outcome::settled:
    return "settled";
  case dem::Outcome::step_limit:
    return "did not come to rest within the allowed steps";
  case dem::Outcome::unstable:
    return "became unstable";
  case dem::Outcome::stopped:
    return stopped_on_request;
  }
  return "ended";
}

std::string failure_of(const triaxial::Snapshot& stage) {
  return stage.report.converged() ? ""
                                  : "compression to " + pretty(stage.pressure, Dimension::pressure) + " " +
                                        words(stage.report.outcome);
}

std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const FileError&) {
    throw;
  } catch (const Stopped&) {
    throw;
  } catch (const std::bad_alloc&) { // no fault of this specimen: the others would end in the same way
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::string failure_or_stop_of(const std::function<void()>& work) {
  try {
    return failure_of(work);
  } catch (const Stopped& stopped) {
    return stopped.what();
  }
}

} // namespace granum::studies

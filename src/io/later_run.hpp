// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/text/source.hpp>

/// A job that was restarted writes some steps twice: the later run answers for them.
/// Checked by tests/io/test_later_run.cpp
namespace granum::io {

inline constexpr double no_moment = std::numeric_limits<double>::infinity();

/// The step or time of a frame that ends early: a little later, so that a run that writes it again goes
/// back.
inline double ends_early(double moment) { return std::nextafter(moment, no_moment); }

/// Frames that a later run wrote again. A run begins with a frame whose step, or time, is less than that of
/// the frame ahead of it; frames ahead of it from the same step on belong to the run that it replaces.
/// \param    moments   steps or times in the order of the frames
inline std::vector<bool> replaced(std::span<const double> moments) {
  std::vector<bool> out(moments.size());
  double begin = no_moment;
  for (std::size_t k = moments.size(); k-- > 0;) {
    out[k] = begin < no_moment && moments[k] >= begin;
    if (k > 0 && moments[k] < moments[k - 1])
      begin = std::min(begin, moments[k]);
  }
  return out;
}

/// What is said about them.
inline std::string replaced_text(const std::string& file, std::size_t frames, double begin) {
  return file + ": a later run of the job begins again at " + short_text(begin, 12) + ": it answers, and " +
         std::to_string(frames) + " earlier frames from this step or time on were left out";
}

/// The frames of a file without those that a later run wrote again; a pipe, which is read once, has all.
/// File is made of a TextSource; source() is that, and skip() passes over a frame and returns its step or
/// time (ends_early), NaN where that is not clear, and nothing at the end.
template <class File>
class LaterRun {
 public:
  explicit LaterRun(TextSource source) : file_(std::move(source)) {
    try { // what is wrong with the file is said where it is read
      if (auto copy = file_.source().again())
        for (File frames(std::move(*copy)); const auto moment = frames.skip();)
          moments_.push_back(*moment);
    } catch (const FileError&) {
    }
    if (std::ranges::any_of(moments_, [](double moment) { return std::isnan(moment); }))
      moments_.clear();
    replaced_ = replaced(moments_);
  }
  /// The file before its next frame.
  File& next() {
    for (; at_ < replaced_.size() && replaced_[at_]; ++at_)
      (void)file_.skip();
    ++at_;
    return file_;
  }
  [[nodiscard]] const File& file() const { return file_; }
  [[nodiscard]] const std::vector<double>& moments() const { return moments_; }
  /// Number of the frame that was read last, from 0.
  [[nodiscard]] long number() const { return static_cast<long>(at_) - 1; }

 private:
  File file_;
  std::vector<double> moments_;
  std::vector<bool> replaced_;
  std::size_t at_ = 0;
};

} // namespace granum::io

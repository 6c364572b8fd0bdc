// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include <expat.h>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>
#include <granum/io/vtk/xml.hpp>

#include "document.hpp"
#include "io/later_run.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

/// Leaves out what a restarted job wrote again. A list that is not in the order of its times, but has each
/// once, is of one run.
void keep_later_run(std::vector<SeriesEntry>& entries) {
  std::vector<double> times;
  for (const SeriesEntry& entry : entries)
    times.push_back(entry.time);
  const std::vector<bool> again = replaced(times);
  std::ranges::sort(times);
  if (std::ranges::adjacent_find(times) == times.end())
    return;
  std::vector<SeriesEntry> kept;
  std::size_t left_out = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    left_out += again[k] ? 1U : 0U;
    if (!again[k]) {
      kept.push_back(std::move(entries[k]));
      kept.back().replaced = std::exchange(left_out, 0);
    }
  }
  entries = std::move(kept);
}

/// The states in the order of their times.
/// \throws   FileError for two of one time
std::vector<SeriesEntry> in_order(std::vector<SeriesEntry> entries, const std::string& name) {
  keep_later_run(entries);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (entries[k].time == entries[k - 1].time)
      throw FileError(name, 0,
                      "expected one data set for each time, found several of timestep " +
                          short_text(entries[k].time, 17) + ": write the state of a time in one part");
  return entries;
}

/// The data sets of a series, or the pieces of a parallel file, as expat finds them.
class Collection {
 public:
  Collection(TextSource source, bool parallel)
      : source_(std::move(source)), parallel_(parallel), expat_(XML_ParserCreate(nullptr), &XML_ParserFree) {
    if (!expat_)
      throw std::bad_alloc();
    XML_SetUserData(expat_.get(), this);
    XML_SetStartElementHandler(expat_.get(), on_begin);
    XML_SetStartDoctypeDeclHandler(expat_.get(), on_doctype);
  }
  Collection(const Collection&) = delete;
  Collection& operator=(const Collection&) = delete;

  std::vector<SeriesEntry> read() {
    constexpr std::size_t most = 1 << 20; // expat takes an int
    for (std::string_view bytes = source_.next_bytes(); !bytes.empty(); bytes = source_.next_bytes())
      for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size())))
        take(bytes.substr(0, most), false);
    take({}, true);
    if (entries_.empty())
      fail(0, parallel_ ? "expected elements Piece, found none" : "expected elements DataSet, found none");
    return parallel_ ? std::move(entries_) : in_order(std::move(entries_), source_.name());
  }

 private:
  /// expat is C, through which no exception may pass.
  template <class Action>
  static void guard(void* self, Action action) {
    auto& collection = *static_cast<Collection*>(self);
    if (collection.failure_)
      return;
    try {
      action(collection);
    } catch (...) {
      collection.failure_ = std::current_exception();
      XML_StopParser(collection.expat_.get(), XML_FALSE);
    }
  }
  static void on_begin(void* self, const char* element, const char** attributes) {
    guard(self, [&](Collection& collection) { collection.begin(element, attributes); });
  }
  static void on_doctype(void* self, const char*, const char*, const char*, int) {
    guard(self, [](Collection& collection) {
      collection.fail(collection.line(), "expected an element VTKFile, found a document type");
    });
  }

  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(expat_.get()); }
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw FileError(source_.name(), line, what);
  }

  void take(std::string_view bytes, bool last) {
    const XML_Status status =
        XML_Parse(expat_.get(), bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0);
    if (failure_)
      std::rethrow_exception(failure_);
    if (status == XML_STATUS_ERROR)
      fail(line(), std::string("is no XML: ") + XML_ErrorString(XML_GetErrorCode(expat_.get())));
  }

  void begin(std::string_view element, const char** attribute) {
    std::string_view type, file, time, source;
    for (; *attribute; attribute += 2) {
      const std::string_view name = attribute[0];
      (name == "type"       ? type
       : name == "file"     ? file
       : name == "timestep" ? time
       : name == "Source"   ? source
                            : ignored_) = attribute[1];
    }
    if (!begun_ && (element != "VTKFile" || (!parallel_ && type != "Collection")))
      fail(line(), "expected an element VTKFile of type Collection, found " + shown(element));
    begun_ = true;
    if (parallel_ && element == "Piece")
      add(source, static_cast<double>(entries_.size()));
    if (parallel_ || element != "DataSet")
      return;
    const auto number = parse_number(time);
    if (!number || !std::isfinite(*number))
      fail(line(), "expected a number as timestep of a DataSet, found " + shown(time));
    add(file, *number);
  }

  void add(std::string_view file, double time) {
    if (file.empty())
      fail(line(), std::string("expected the name of a file in a ") + (parallel_ ? "Piece" : "DataSet"));
    entries_.push_back({time, std::string(file)});
  }

  TextSource source_;
  bool parallel_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> expat_;
  std::vector<SeriesEntry> entries_;
  std::string_view ignored_;
  bool begun_ = false;
  std::exception_ptr failure_;
};

/// Whether the first element VTKFile has one of some words.
bool is_of_type(TextSource& source, std::initializer_list<std::string_view> types) {
  for (int k = 0; k < lines_looked_at && source.next(); ++k) {
    const std::string_view line = trimmed(source.line());
    if (k == 0 && !line.starts_with("<?xml") && !line.starts_with("<VTKFile"))
      return false;
    if (const std::size_t at = line.find("<VTKFile"); at != std::string_view::npos)
      return std::ranges::any_of(types, [&](auto type) { return line.find(type, at) != line.npos; });
  }
  return false;
}

constexpr std::string_view json_mark = "\"file-series-version\"";

/// The value of a key in an object of JSON without objects in it: a text without its quotes, or a number;
/// empty if there is none.
std::string_view json_value(std::string_view object, std::string_view key) {
  const std::size_t at = object.find("\"" + std::string(key) + "\"");
  if (at == std::string_view::npos)
    return {};
  std::string_view value = object.substr(at + key.size() + 2);
  value.remove_prefix(std::min(value.find_first_not_of(" \t\r\n:"), value.size()));
  if (value.starts_with('"'))
    return value.substr(1, value.find('"', 1) - 1);
  return trimmed(value.substr(0, value.find_first_of(",}\r\n")));
}

/// ParaView's .vtu.series: {"file-series-version": "1.0", "files": [{"name": "a.vtu", "time": 0}, ...]}.
std::vector<SeriesEntry> read_json_series(TextSource source) {
  std::string text;
  while (source.next())
    (text += source.line()) += '\n';
  const std::size_t files = text.find("\"files\"");
  std::vector<SeriesEntry> entries;
  for (std::size_t at = files; at != std::string::npos && (at = text.find('{', at)) != std::string::npos;) {
    const std::size_t end = text.find('}', at);
    const std::string_view object = std::string_view(text).substr(at, end - at);
    const std::string_view name = json_value(object, "name"), time = json_value(object, "time");
    const auto number = parse_number(time);
    if (name.empty() || name.find('\\') != std::string_view::npos || !number || !std::isfinite(*number))
      throw FileError(
          source.name(),
          1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')),
          "expected {\"name\": \"...\", \"time\": number}, found " + shown(object));
    entries.push_back({*number, std::string(name)});
    at = end;
  }
  if (entries.empty())
    throw FileError(source.name(), 0, "expected a list of files, found none");
  return in_order(std::move(entries), source.name());
}

bool is_json(TextSource& source) {
  for (int k = 0; k < lines_looked_at && source.next(); ++k) {
    if (k == 0 && !trimmed(source.line()).starts_with('{'))
      return false;
    if (source.line().find(json_mark) != std::string_view::npos)
      return true;
  }
  return false;
}

} // namespace

bool is_collection(TextSource& source) {
  source.keep_from_start();
  if (is_json(source))
    return true;
  source.back_to_start();
  return is_of_type(source, {"Collection"});
}

std::vector<SeriesEntry> read_collection(TextSource source) {
  source.keep_from_start();
  const bool json = is_json(source);
  source.back_to_start();
  source.stop_keeping();
  return json ? read_json_series(std::move(source)) : Collection(std::move(source), false).read();
}

bool is_parallel(TextSource& source) {
  return is_of_type(source, {"\"PUnstructuredGrid\"", "\"PPolyData\""});
}

std::vector<std::string> read_pieces(TextSource source) {
  std::vector<std::string> out;
  for (SeriesEntry& piece : Collection(std::move(source), true).read())
    out.push_back(std::move(piece.file));
  return out;
}

} // namespace granum::io

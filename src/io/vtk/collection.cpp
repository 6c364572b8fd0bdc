// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/collection.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <string_view>

#include <expat.h>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/packing_format.hpp>

#include "io/text/row.hpp"

namespace granum::io {

namespace {

/// The data sets of a series, as expat finds them.
class Collection {
 public:
  explicit Collection(TextSource source)
      : source_(std::move(source)), expat_(XML_ParserCreate(nullptr), &XML_ParserFree) {
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
      fail(0, "expected elements DataSet, found none");
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
    for (std::size_t k = 1; k < entries_.size(); ++k)
      if (entries_[k].time == entries_[k - 1].time)
        fail(0, "expected one data set for each time, found several of timestep " +
                    short_text(entries_[k].time, 17) + ": write the state of a time in one part");
    return std::move(entries_);
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
    std::string_view type, file, time;
    for (; *attribute; attribute += 2) {
      const std::string_view name = attribute[0];
      (name == "type" ? type : name == "file" ? file : name == "timestep" ? time : ignored_) = attribute[1];
    }
    if (!begun_ && (element != "VTKFile" || type != "Collection"))
      fail(line(), "expected an element VTKFile of type Collection, found " + shown(element));
    begun_ = true;
    if (element != "DataSet")
      return;
    const auto number = parse_number(time);
    if (!number || !std::isfinite(*number))
      fail(line(), "expected a number as timestep of a DataSet, found " + shown(time));
    if (file.empty())
      fail(line(), "expected the name of a file in a DataSet");
    entries_.push_back({*number, std::string(file)});
  }

  TextSource source_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> expat_;
  std::vector<SeriesEntry> entries_;
  std::string_view ignored_;
  bool begun_ = false;
  std::exception_ptr failure_;
};

} // namespace

bool is_collection(TextSource& source) {
  for (int k = 0; k < lines_looked_at && source.next(); ++k) {
    const std::string_view line = trimmed(source.line());
    if (k == 0 && !line.starts_with("<?xml") && !line.starts_with("<VTKFile"))
      return false;
    if (const std::size_t at = line.find("<VTKFile"); at != std::string_view::npos)
      return line.substr(at).find("Collection") != std::string_view::npos;
  }
  return false;
}

std::vector<SeriesEntry> read_collection(TextSource source) { return Collection(std::move(source)).read(); }

} // namespace granum::io

// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/text/source.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <system_error>

#include <zlib.h>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>

#include "row.hpp"

namespace granum::io {

/// A file opened by zlib, which passes plain text unchanged.
struct TextSource::Stream {
  gzFile file = nullptr;
  bool seekable = false; ///< else a pipe
  bool ended = false;

  Stream(gzFile opened, bool can_seek) : file(opened), seekable(can_seek) {}
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { gzclose(file); }
};

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16; // also the most that one call reads

gzFile opened(const std::filesystem::path& path) {
  std::error_code unknown; // impossible names are reported on opening
  if (std::filesystem::is_directory(path, unknown))
    throw FileError(path.string(), 0, "cannot be read: it is a folder");
  errno = 0;
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr)
    throw FileError(path.string(), 0, std::string("cannot be read: ") + std::strerror(errno));
  gzbuffer(file, buffer_size);
  return file;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::is_regular_file(path, unknown);
}

} // namespace

TextSource::TextSource(std::string name, std::unique_ptr<Stream> stream)
    : name_(std::move(name)), stream_(std::move(stream)) {}

TextSource::TextSource(const std::filesystem::path& path)
    : TextSource(path.string(), std::make_unique<Stream>(opened(path), is_file(path))) {
  buffer_.resize(buffer_size);
}

TextSource TextSource::of_text(std::string name, std::string_view text) {
  TextSource source(std::move(name), nullptr);
  source.buffer_.assign(text.begin(), text.end());
  source.end_ = text.size();
  return source;
}

TextSource::TextSource(TextSource&&) noexcept = default;
TextSource& TextSource::operator=(TextSource&&) noexcept = default;
TextSource::~TextSource() = default;

/// Reads more text into the buffer; false at the end of the file.
bool TextSource::fill() {
  if (!stream_ || stream_->ended)
    return false;
  stop_point();
  if (begin_ > 0 && !keeping_) {
    dropped_ = true;
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ - begin_ >= longest_line)
    throw FileError(name_, line_number_ + 1, "a line of more than 64 MiB; expected a text file");
  if (end_ == buffer_.size())
    buffer_.resize(2 * buffer_.size());
  const std::size_t room = std::min(buffer_.size() - end_, buffer_size);
  const int count = gzread(stream_->file, buffer_.data() + end_, static_cast<unsigned>(room));
  int status = Z_OK;
  const char* message = gzerror(stream_->file, &status);
  if (status == Z_BUF_ERROR)
    throw CutFile(name_, line_number_, "the compressed data end too early: the file is cut off");
  if (status == Z_ERRNO && errno == EINTR)
    stop_point();
  if (count < 0 || (status != Z_OK && status != Z_STREAM_END))
    throw FileError(name_, line_number_,
                    std::string("cannot be read further: ") +
                        (status == Z_ERRNO ? std::strerror(errno) : message));
  end_ += static_cast<std::size_t>(count);
  stream_->ended = count == 0;
  return count > 0;
}

/// Makes [begin_, end) the current line; reading continues at `next`.
void TextSource::take(std::size_t end, std::size_t next) {
  line_ = std::string_view(buffer_.data() + begin_, end - begin_);
  if (line_.ends_with('\r'))
    line_.remove_suffix(1);
  if (++line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF"))
    line_.remove_prefix(3);
  begin_ = next;
}

bool TextSource::next() {
  stop_point(line_number_);
  if (held_) {
    held_ = false;
    return true;
  }
  std::size_t searched = 0; // bytes from begin_ without line end
  for (;;) {
    const char* from = buffer_.data() + begin_ + searched;
    const std::size_t length = end_ - begin_ - searched;
    if (const void* found = length > 0 ? std::memchr(from, '\n', length) : nullptr) {
      const auto end = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
      take(end, end + 1);
      return true;
    }
    searched = end_ - begin_;
    if (fill())
      continue;
    if (searched == 0) {
      line_ = {};
      return false;
    }
    take(end_, end_);
    return true;
  }
}

void TextSource::keep_from_start() { keeping_ = stream_ && !stream_->seekable; }

void TextSource::back_to_start() {
  if (dropped_) {
    if (gzrewind(stream_->file) != 0)
      fail("cannot be read a second time");
    stream_->ended = dropped_ = false;
    end_ = 0;
  }
  begin_ = line_number_ = 0;
  held_ = false;
}

std::optional<TextSource> TextSource::again() const {
  if (!stream_)
    return of_text(name_, {buffer_.data(), end_});
  return stream_->seekable ? std::optional(TextSource(std::filesystem::path(name_))) : std::nullopt;
}

std::string_view TextSource::next_bytes() {
  if (begin_ == end_ && !fill())
    return {};
  const std::string_view bytes(buffer_.data() + begin_, end_ - begin_);
  begin_ = end_;
  return bytes;
}

void TextSource::fail(const std::string& what) const {
  if (begin_ == end_ && (!stream_ || stream_->ended))
    throw CutFile(name_, line_number_, what);
  throw FileError(name_, line_number_, what);
}

std::string file_content(const std::filesystem::path& path, std::size_t most) {
  TextSource source(path);
  std::string content;
  for (std::string_view bytes = source.next_bytes(); !bytes.empty(); bytes = source.next_bytes()) {
    content += bytes;
    if (content.size() > most)
      source.fail("is longer than " + std::to_string(most) + " bytes");
  }
  return content;
}

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

/// A letter or digit; parts of letters beyond ASCII count as such.
bool in_word(char c) {
  return digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Takes the digits off the front of a text, without zeros in front.
std::string_view leading_digits(std::string_view& text) {
  const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), digit) - text.begin());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

/// The name with every number, decimal ones too, as one '#'.
std::string without_numbers(std::string_view name) {
  std::string out;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (!digit(name[k])) {
      out += name[k];
      continue;
    }
    out += '#';
    while (k + 1 < name.size() &&
           (digit(name[k + 1]) || (name[k + 1] == '.' && k + 2 < name.size() && digit(name[k + 2]))))
      ++k;
  }
  return out;
}

/// How many characters all names begin with, up to the end of a word.
template <class Characters>
std::size_t common_words(const std::vector<std::string>& names, const Characters& characters) {
  const std::string first = characters(names.front());
  std::size_t common = first.size();
  for (const std::string& name : names) {
    const std::string other = characters(name);
    const auto end = std::mismatch(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(common),
                                   other.begin(), other.end());
    common = static_cast<std::size_t>(end.first - first.begin());
  }
  while (common > 0 && in_word(first[common - 1]))
    --common;
  return common;
}

} // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (digit(a.front()) && digit(b.front())) {
      const std::string_view x = leading_digits(a), y = leading_digits(b);
      if (x != y)
        return x.size() != y.size() ? x.size() < y.size() : x < y;
      continue;
    }
    if (a.front() != b.front())
      return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty())
    return a.empty();
  return whole_a < whole_b; // 7 and 007
}

std::vector<std::string> series_by_name(const std::vector<std::string>& files) {
  std::vector<std::string> keys;
  for (const std::string& file : files)
    keys.push_back(without_numbers(file));
  if (std::all_of(keys.begin(), keys.end(), [&](const std::string& key) { return key == keys.front(); })) {
    const std::string name = files.empty() ? "" : files.front().substr(files.front().find_last_of('/') + 1);
    return std::vector<std::string>(files.size(), name);
  }
  const std::size_t front = common_words(keys, [](const std::string& key) { return key; });
  const std::size_t back =
      common_words(keys, [](const std::string& key) { return std::string(key.rbegin(), key.rend()); });
  std::vector<std::string> out;
  for (const std::string& key : keys)
    out.push_back(front + back < key.size() ? key.substr(front, key.size() - front - back) : key);
  return out;
}

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

} // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string piece(text.substr(0, longest));
  for (char& c : piece)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e)
      c = '?';
  return "'" + piece + (text.size() > longest ? "...'" : "'");
}

int significant_digits(std::string_view number) {
  int digits = 0;
  for (const char c : number) {
    if (c == 'e' || c == 'E')
      break;
    if (digit(c) && (digits > 0 || c != '0'))
      ++digits;
  }
  return digits;
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

void TextRow::split() {
  fields_.clear();
  const std::string_view line = source_->line();
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end) {
    while (at != end && blank(*at))
      ++at;
    const char* const begin = at;
    while (at != end && !blank(*at))
      ++at;
    if (at != begin)
      fields_.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
}

void TextRow::require_size(std::size_t count, std::string_view what) const {
  if (fields_.size() != count)
    source_->fail("expected " + std::to_string(count) + " " + std::string(what) + ", found " +
                  std::to_string(fields_.size()));
}

std::string_view TextRow::field(std::size_t k, std::string_view what) const {
  if (k >= fields_.size())
    source_->fail("expected " + std::string(what) + " as field " + std::to_string(k + 1) + ", found " +
                  std::to_string(fields_.size()) + " fields");
  return fields_[k];
}

double TextRow::number(std::size_t k, std::string_view what) const {
  const std::string_view text = field(k, what);
  const auto number = leading_number(text);
  if (!number || !number->rest.empty())
    source_->fail("expected a finite number as " + std::string(what) + ", found " + shown(text));
  return number->value;
}

Vec3 TextRow::vector(std::size_t k, std::string_view what) const {
  return {number(k, what), number(k + 1, what), number(k + 2, what)};
}

long TextRow::integer(std::size_t k, std::string_view what) const {
  const std::string_view text = field(k, what);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size())
    return value;
  const double written = number(k, what);
  if (written != std::floor(written) || std::abs(written) > 9e15)
    source_->fail("expected an integer as " + std::string(what) + ", found " + shown(text));
  const auto whole = static_cast<long>(written);
  if (significant_digits(text) < static_cast<int>(std::to_string(std::abs(whole)).size()))
    source_->fail(std::string(what) + " " + shown(text) +
                  " has lost digits: write the file again with more (format float %.17g)");
  return whole;
}

std::size_t TextRow::count(std::size_t k, std::string_view what) const {
  const long value = integer(k, what);
  if (value < 0)
    source_->fail("expected a number of " + std::string(what) + ", found " + std::to_string(value));
  return static_cast<std::size_t>(value);
}

} // namespace granum::io

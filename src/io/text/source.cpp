// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/text/source.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <zlib.h>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>

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
    throw FileError(name_, line_number_, "the compressed data end too early: the file is cut off");
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

std::string_view TextSource::next_bytes() {
  if (begin_ == end_ && !fill())
    return {};
  const std::string_view bytes(buffer_.data() + begin_, end_ - begin_);
  begin_ = end_;
  return bytes;
}

void TextSource::fail(const std::string& what) const { throw FileError(name_, line_number_, what); }

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

} // namespace granum::io

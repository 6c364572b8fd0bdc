// SPDX-License-Identifier: GPL-3.0-or-later
#include "document.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>

#include <expat.h>
#include <zlib.h>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>

#include "io/text/row.hpp"

namespace granum::io {

namespace {

using Attributes = std::map<std::string, std::string, std::less<>>;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string value_of(const Attributes& attributes, std::string_view name, std::string otherwise = "") {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::move(otherwise) : found->second;
}

/// A count in an attribute; empty if it is not a count.
std::optional<std::size_t> counted(const std::string& text) {
  const auto number = parse_number(text);
  if (!number || *number < 0 || *number > 9e15 ||
      *number != static_cast<double>(static_cast<std::size_t>(*number)))
    return std::nullopt;
  return static_cast<std::size_t>(*number);
}

/// Whether the arrays of this section are read.
bool holds_arrays(std::string_view element) {
  return element == "Points" || element == "PointData" || element == "CellData" || element == "Lines" ||
         element == "FieldData";
}

template <class Number>
double number_at(const char* bytes, bool big_endian) {
  char own[sizeof(Number)];
  std::memcpy(own, bytes, sizeof own);
  if (big_endian == (std::endian::native == std::endian::little))
    std::ranges::reverse(own);
  Number number;
  std::memcpy(&number, own, sizeof number);
  return static_cast<double>(number);
}

/// A type of numbers that VTK packs.
struct NumberType {
  const char* name;
  std::size_t size;
  double (*read)(const char* bytes, bool big_endian);
};

template <class Number>
constexpr NumberType number_type(const char* name) {
  return {name, sizeof(Number), number_at<Number>};
}

constexpr NumberType number_types[] = {
    number_type<double>("Float64"),     number_type<float>("Float32"),
    number_type<std::int64_t>("Int64"), number_type<std::uint64_t>("UInt64"),
    number_type<std::int32_t>("Int32"), number_type<std::uint32_t>("UInt32"),
    number_type<std::int16_t>("Int16"), number_type<std::uint16_t>("UInt16"),
    number_type<std::int8_t>("Int8"),   number_type<std::uint8_t>("UInt8")};

bool white_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// YADE's points contain NaN in place of removed bodies.
bool is_nan(std::string_view word) {
  return word.size() <= 4 && (lower(std::string(word)) == "nan" || lower(std::string(word)) == "-nan");
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && white_space(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && white_space(text.back()))
    text.remove_suffix(1);
  return text;
}

/// Value of a base64 character; -1 for none.
int base64_value(char c) {
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Hands out bytes, decoded on the way. Base64 may be padded in the middle, as VTK encodes the sizes of
/// compressed blocks by themselves.
class ByteStream {
 public:
  ByteStream(std::string_view packed, bool base64) : rest_(packed), base64_(base64) {}

  std::string take(std::uint64_t count) {
    if (count > decoded_.size() + rest_.size())
      throw InvalidArgument("the data end too early");
    if (!base64_) {
      const std::string bytes(rest_.substr(0, count));
      rest_.remove_prefix(count);
      return bytes;
    }
    while (decoded_.size() < count)
      decode_group();
    std::string bytes = decoded_.substr(0, count);
    decoded_.erase(0, count);
    return bytes;
  }

 private:
  /// Four characters, up to three bytes.
  void decode_group() {
    if (rest_.size() < 4)
      throw InvalidArgument("the data end too early");
    std::uint32_t bits = 0;
    int characters = 0;
    for (; characters < 4 && rest_[static_cast<std::size_t>(characters)] != '='; ++characters) {
      const int value = base64_value(rest_[static_cast<std::size_t>(characters)]);
      if (value < 0)
        throw InvalidArgument("expected base64");
      bits |= static_cast<std::uint32_t>(value) << (18 - 6 * characters);
    }
    if (characters < 2 || (characters < 4 && rest_[3] != '='))
      throw InvalidArgument("expected base64");
    for (int k = 0; k < characters - 1; ++k)
      decoded_ += static_cast<char>(bits >> (16 - 8 * k) & 0xff);
    rest_.remove_prefix(4);
  }

  std::string_view rest_;
  std::string decoded_; ///< decoded base64, not yet used
  bool base64_;
};

/// The next number of the header.
std::uint64_t header_number(ByteStream& stream, const VtkEncoding& encoding) {
  const std::string bytes = stream.take(encoding.header_size);
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const std::size_t at = encoding.big_endian ? k : bytes.size() - 1 - k;
    value = value << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return value;
}

std::string inflated(const std::string& block, std::uint64_t size) {
  constexpr std::uint64_t best_ratio = 1032; // of zlib; more is a size that cannot be true
  if (size > best_ratio * (block.size() + 1))
    throw InvalidArgument("a compressed block states a size that it cannot have");
  std::string bytes(size, '\0');
  uLongf length = size;
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(block.data()), block.size()) != Z_OK ||
      length != size)
    throw InvalidArgument("a compressed block is damaged");
  return bytes;
}

std::string inflated_blocks(ByteStream& stream, std::size_t longest, const VtkEncoding& encoding) {
  const std::uint64_t count = header_number(stream, encoding);
  if (count > longest)
    throw InvalidArgument("the data end too early");
  const std::uint64_t size = header_number(stream, encoding), last = header_number(stream, encoding);
  std::vector<std::uint64_t> packed_sizes;
  for (std::uint64_t k = 0; k < count; ++k)
    packed_sizes.push_back(header_number(stream, encoding));
  std::string bytes;
  for (std::uint64_t k = 0; k < count; ++k)
    bytes += inflated(stream.take(packed_sizes[k]), k + 1 == count && last > 0 ? last : size);
  return bytes;
}

/// The bytes of one array.
/// \param    packed   begins where the array begins, and may go on behind it
/// \param    base64   whether `packed` is base64 text, not the bytes themselves
/// \throws   InvalidArgument for data in another encoding, with the reason
/// Checked by tests/io/vtk/test_xml.cpp
std::string unpacked(std::string_view packed, bool base64, const VtkEncoding& encoding) {
  ByteStream stream(packed, base64);
  if (encoding.compressor.empty())
    return stream.take(header_number(stream, encoding));
  if (encoding.compressor == "vtkZLibDataCompressor")
    return inflated_blocks(stream, packed.size(), encoding);
  throw InvalidArgument("compressed by " + encoding.compressor +
                        ", which is not read: write the file with vtkZLibDataCompressor, or as text");
}

} // namespace

/// Hands the elements that expat finds to the document.
struct VtkDocument::Parser {
  using Handle = std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)>;

  VtkDocument* document;
  Handle expat{XML_ParserCreate(nullptr), &XML_ParserFree};
  std::vector<std::string> open; ///< elements around the place here
  Array* array = nullptr;        ///< that is open
  std::size_t array_depth = 0;
  std::exception_ptr failure;
  std::optional<std::size_t> appended_from; ///< byte of the file

  explicit Parser(VtkDocument& owner) : document(&owner) {
    if (!expat)
      throw std::bad_alloc();
    XML_SetUserData(expat.get(), this);
    XML_SetElementHandler(expat.get(), on_begin, on_end);
    XML_SetCharacterDataHandler(expat.get(), on_text);
    XML_SetStartDoctypeDeclHandler(expat.get(), on_doctype);
  }

  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(expat.get()); }

  /// expat is C, through which no exception may pass.
  template <class Action>
  static void guard(void* self, Action action) {
    auto& parser = *static_cast<Parser*>(self);
    if (parser.failure || parser.appended_from)
      return;
    try {
      action(parser);
    } catch (...) {
      parser.failure = std::current_exception();
      XML_StopParser(parser.expat.get(), XML_FALSE);
    }
  }

  static void on_begin(void* self, const char* element, const char** attributes) {
    guard(self, [&](Parser& parser) { parser.begin(element, attributes); });
  }
  static void on_end(void* self, const char*) {
    guard(self, [](Parser& parser) { parser.end(); });
  }
  static void on_text(void* self, const char* text, int length) {
    guard(self, [&](Parser& parser) {
      if (parser.array && parser.open.size() == parser.array_depth) {
        if (parser.array->text.empty())
          parser.array->line = parser.line();
        parser.array->text.append(text, static_cast<std::size_t>(length));
      }
    });
  }
  static void on_doctype(void* self, const char*, const char*, const char*, int) {
    guard(self, [](Parser& parser) {
      parser.document->fail(parser.line(), "expected an element VTKFile, found a document type");
    });
  }

  void begin(const std::string& element, const char** attribute) {
    Attributes attributes;
    for (; *attribute; attribute += 2)
      attributes[attribute[0]] = attribute[1];
    if (open.empty()) {
      if (element != "VTKFile")
        document->fail(line(), "expected an element VTKFile, found " + shown(element));
      document->read_head(attributes, line());
    } else if (element == "Piece") {
      document->read_piece(attributes, line());
    } else if (element == "DataArray" && holds_arrays(open.back()) && !array) {
      array = document->read_array(open.back(), std::move(attributes), line());
      array_depth = open.size() + 1;
    } else if (element == "AppendedData") {
      const std::string encoding = value_of(attributes, "encoding");
      if (encoding != "base64" && encoding != "raw")
        document->fail(line(),
                       "expected the encoding base64 or raw of AppendedData, found " + shown(encoding));
      document->appended_base64_ = encoding == "base64";
      appended_from = static_cast<std::size_t>(XML_GetCurrentByteIndex(expat.get())) +
                      static_cast<std::size_t>(XML_GetCurrentByteCount(expat.get()));
      XML_StopParser(expat.get(), XML_FALSE); // the rest need not be XML
      return;
    }
    open.push_back(element);
  }

  void end() {
    if (array && open.size() == array_depth)
      array = nullptr;
    open.pop_back();
  }

  /// Takes the next bytes of the file; false once the elements have ended.
  bool take(std::string_view bytes, bool last) {
    const XML_Status status =
        XML_Parse(expat.get(), bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0);
    if (failure)
      std::rethrow_exception(failure);
    if (!appended_from && status == XML_STATUS_ERROR)
      document->fail(line(), std::string("is no XML: ") + XML_ErrorString(XML_GetErrorCode(expat.get())));
    return !appended_from;
  }
};

VtkDocument::VtkDocument(TextSource source) : source_(std::move(source)) {
  Parser parser(*this);
  std::size_t before = 0; // bytes of the file
  bool elements = true;
  for (;;) {
    constexpr std::size_t most = 1 << 20; // expat takes an int
    std::string_view bytes = source_.next_bytes();
    if (bytes.empty())
      break;
    for (; elements && !bytes.empty();) {
      const std::string_view part = bytes.substr(0, most);
      elements = parser.take(part, false);
      const std::size_t taken = elements ? part.size() : *parser.appended_from - before;
      bytes.remove_prefix(taken);
      before += taken;
    }
    appended_ += bytes;
  }
  if (elements)
    (void)parser.take({}, true);
  const std::size_t mark = appended_.find('_');
  appended_.erase(0, mark == std::string::npos ? appended_.size() : mark + 1);
  if (!piece_)
    fail(0, "expected an element Piece");
}

void VtkDocument::fail(std::size_t line, const std::string& what) const {
  throw FileError(name(), line, what);
}

void VtkDocument::read_head(const Attributes& attributes, std::size_t line) {
  type_ = value_of(attributes, "type");
  encoding_.compressor = value_of(attributes, "compressor");
  const std::string order = value_of(attributes, "byte_order", "LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    fail(line, "expected the byte_order LittleEndian or BigEndian, found " + shown(order));
  encoding_.big_endian = order == "BigEndian";
  const std::string header = value_of(attributes, "header_type", "UInt32");
  if (header != "UInt32" && header != "UInt64")
    fail(line, "expected the header_type UInt32 or UInt64, found " + shown(header));
  encoding_.header_size = header == "UInt64" ? 8 : 4;
}

void VtkDocument::read_piece(const Attributes& attributes, std::size_t line) {
  if (piece_)
    fail(line, "expected one element Piece, found another: write the file in one piece");
  piece_.emplace();
  for (const auto& [name, value] : attributes) {
    const auto count = counted(value);
    if (!count && name.starts_with("NumberOf"))
      fail(line, "expected a count as " + name + ", found " + shown(value));
    if (count)
      (*piece_)[name] = *count;
  }
}

VtkDocument::Array* VtkDocument::read_array(const std::string& section, Attributes attributes,
                                            std::size_t line) {
  const std::string name = lower(value_of(attributes, "Name"));
  Array& array = arrays_[{section, name}];
  array = {std::move(attributes), {}, line};
  return &array;
}

std::size_t VtkDocument::count(const std::string& what) const {
  const auto found = piece_->find(what);
  return found == piece_->end() ? 0 : found->second;
}

const VtkDocument::Array* VtkDocument::find(const std::string& section, const std::string& name) const {
  const auto found = name.empty() ? arrays_.lower_bound({section, ""}) : arrays_.find({section, name});
  return found != arrays_.end() && found->first.first == section ? &found->second : nullptr;
}

std::optional<VtkNumbers> VtkDocument::numbers(const std::string& section, const std::string& name,
                                               std::size_t tuples, std::size_t components) const {
  const Array* array = find(section, name);
  if (!array)
    return std::nullopt;
  const std::string what = section + (name.empty() ? "" : ": " + name);
  const auto found = counted(value_of(array->attributes, "NumberOfComponents", "1"));
  if (found != components && section != "FieldData")
    fail(array->line, "expected " + what + " of " + std::to_string(components) + " components, found " +
                          shown(value_of(array->attributes, "NumberOfComponents", "1")));
  VtkNumbers out{.values = {}, .line = array->line};
  out.single_precision = value_of(array->attributes, "type") == "Float32";
  const std::string format = value_of(array->attributes, "format", "ascii");
  if (format == "ascii")
    read_text(*array, what, tuples * components, out);
  else if (format == "binary" || format == "appended")
    read_packed(*array, what, tuples * components, out);
  else
    fail(array->line,
         "expected the format ascii, binary or appended of " + what + ", found " + shown(format));
  return out;
}

void VtkDocument::read_text(const Array& array, const std::string& what, std::size_t count,
                            VtkNumbers& out) const {
  const std::string_view text = array.text;
  std::size_t line = array.line;
  for (std::size_t at = 0; at < text.size();) {
    stop_point(at);
    if (white_space(text[at])) {
      line += text[at++] == '\n' ? std::size_t{1} : 0;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const auto number = leading_number(word);
    const bool none = is_nan(word);
    if (!none && (!number || !number->rest.empty()))
      fail(line, "expected a finite number in " + what + ", found " + shown(word));
    if (out.values.size() == count)
      fail(line, "expected " + std::to_string(count) + " numbers in " + what + ", found more");
    out.values.push_back(none ? std::numeric_limits<double>::quiet_NaN() : number->value);
    out.digits.see(word);
    at = end;
  }
  if (out.values.size() != count)
    fail(line, "expected " + std::to_string(count) + " numbers in " + what + ", found " +
                   std::to_string(out.values.size()));
}

std::string VtkDocument::bytes(const Array& array, const std::string& what) const {
  try {
    if (value_of(array.attributes, "format") == "binary")
      return unpacked(without_blanks(array.text), true, encoding_);
    const auto offset = counted(value_of(array.attributes, "offset"));
    if (!offset || *offset > appended_.size())
      throw InvalidArgument("expected an offset within the appended data, found " +
                            shown(value_of(array.attributes, "offset")));
    return unpacked(std::string_view(appended_).substr(*offset), appended_base64_, encoding_);
  } catch (const InvalidArgument& error) {
    fail(array.line, what + ": " + error.what());
  }
}

void VtkDocument::read_packed(const Array& array, const std::string& what, std::size_t count,
                              VtkNumbers& out) const {
  const std::string name = value_of(array.attributes, "type");
  const auto* type = std::ranges::find_if(number_types, [&](const NumberType& t) { return t.name == name; });
  if (type == std::end(number_types))
    fail(array.line,
         "expected numbers Float64, Float32, Int64 and so on in " + what + ", found " + shown(name));
  const std::string packed = bytes(array, what);
  if (packed.size() % type->size != 0 || packed.size() / type->size != count)
    fail(array.line, "expected " + std::to_string(count) + " numbers of " + std::to_string(type->size) +
                         " bytes in " + what + ", found " + std::to_string(packed.size()) + " bytes");
  out.values.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    out.values.push_back(type->read(packed.data() + k * type->size, encoding_.big_endian));
}

CentreIndex::CentreIndex(const std::vector<Vec3>& centres) {
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const Vec3& p = centres[k];
    const auto [at, fresh] = index_.emplace(Key{p.x, p.y, p.z}, static_cast<std::uint32_t>(k));
    if (!fresh)
      at->second = several;
  }
}

std::optional<std::uint32_t> CentreIndex::look_up(const Vec3& point, const PackingBuilder& builder,
                                                  std::size_t line) const {
  const bool ordered = !std::isnan(point.x) && !std::isnan(point.y) && !std::isnan(point.z);
  const auto found = ordered ? index_.find({point.x, point.y, point.z}) : index_.end();
  if (found == index_.end())
    return std::nullopt;
  if (found->second == several)
    builder.fail_contact(line, "the contact ends where two spheres have their centres");
  return found->second;
}

std::uint32_t CentreIndex::find(const Vec3& point, const PackingBuilder& builder, std::size_t line) const {
  const auto found = look_up(point, builder, line);
  if (!found)
    builder.fail_contact(line, "the contact ends at no centre of a sphere; pairs through periodic faces need "
                               "share/yade/granum_export.py");
  return *found;
}

} // namespace granum::io

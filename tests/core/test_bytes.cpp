// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/bytes.hpp>

#include <granum/core/vec3.hpp>

#include "unit.hpp"

TEST_CASE("values come back to the bit, in the order of writing") {
  ByteWriter writer;
  writer.put(0.1);
  writer.put(std::numeric_limits<double>::quiet_NaN());
  writer.put_all(std::vector<Vec3>{{1, 2, 3}, {-0.0, 5, 6}});
  writer.put_all(std::vector<double>{});
  writer.put(std::uint32_t{7});
  ByteReader reader(writer.bytes(), "somewhere");
  CHECK(reader.get<double>() == 0.1);
  CHECK(std::isnan(reader.get<double>()));
  const auto vectors = reader.get_all<Vec3>();
  CHECK(vectors == std::vector<Vec3>{{1, 2, 3}, {0, 5, 6}});
  CHECK(std::signbit(vectors[1].x));
  CHECK(reader.get_all<double>().empty());
  CHECK_FALSE(reader.empty());
  CHECK(reader.get<std::uint32_t>() == 7);
  CHECK(reader.empty());
}

TEST_CASE("bytes that end too early are an error that names their source") {
  ByteWriter writer;
  writer.put_all(std::vector<double>(3, 1.0));
  const std::string cut = writer.bytes().substr(0, writer.bytes().size() - 1);
  ByteReader list(cut, "run.checkpoint");
  CHECK_THROWS_WITH_AS((void)list.get_all<double>(), doctest::Contains("run.checkpoint"), FileError);
  ByteReader value("1234567", "short");
  CHECK_THROWS_WITH_AS((void)value.get<double>(), doctest::Contains("short"), FileError);
  // A count beyond all memory is no reason to ask for it.
  ByteWriter huge;
  huge.put(std::uint64_t{1} << 62);
  ByteReader counted(huge.bytes(), "huge");
  CHECK_THROWS_AS((void)counted.get_all<double>(), FileError);
}

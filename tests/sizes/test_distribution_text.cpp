// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/distribution.hpp>

#include "unit.hpp"

using namespace granum::sizes;

TEST_CASE("the text of a distribution is read back as the same") {
  for (const char* text :
       {"equal", "bidisperse:1.4:0.5", "uniform:1:3", "lognormal:0.35", "lognormal:0.35:5",
        "power-law:3.5:10", "uniformity:2.5", "uniformity:2.5:8", "sieve:6.3e-05m=0:0.0002m=0.31:0.001m=1"}) {
    const Distribution sizes = parse_distribution(text);
    CHECK(sizes.text() == text);
    const Distribution again = parse_distribution(sizes.text());
    CHECK(again.moment(3) == sizes.moment(3));
    CHECK(again.smallest() == sizes.smallest());
  }
  const Distribution thirds = Distribution::bidisperse(4.0 / 3, 1.0 / 3);
  CHECK(parse_distribution(thirds.text()).moment(3) == thirds.moment(3));
}

TEST_CASE("each form is the maker of its name") {
  CHECK(parse_distribution("bidisperse:1.4") == Distribution::bidisperse(1.4, 0.5));
  CHECK(parse_distribution(" uniform : 1 : 3 ") == Distribution::uniform(1, 3));
  CHECK(parse_distribution("lognormal:0") == Distribution::equal());
  const Distribution sieve = parse_distribution("sieve:0.1mm=0%:0.2mm=40 %:0.5mm=100%");
  CHECK(sieve.share_below(0.1e-3 / *sieve.mean_radius(), 3) == relative(0.4, 1e-13));
}

TEST_CASE("another text is refused with the list of forms, numbers that a form cannot take by their name") {
  for (const char* text :
       {"", "normal:0.3", "lognormal", "lognormal:", "lognormal:a", "lognormal:0.3:5:2", "uniform:1",
        "equal:1", "Lognormal:0.3", "sieve:0.1mm:0.2mm", "uniform:1 3", "lognormal=0.3"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS((void)parse_distribution(text), doctest::Contains(distribution_forms().c_str()),
                         InvalidArgument);
  }
  for (const char* form :
       {"equal", "bidisperse:", "uniform:", "lognormal:", "power-law:", "uniformity:", "sieve:"})
    CHECK(distribution_forms().find(form) != std::string::npos);
  CHECK_THROWS_WITH_AS((void)parse_distribution("lognormal:3"), doctest::Contains("sigma = 3"),
                       InvalidArgument);
  // the last without a unit
  for (const char* text : {"sieve", "bidisperse:1.4:1", "sieve:0.1mm=0:0.2mm=x", "sieve:0.1=0:0.2=1"})
    CHECK_THROWS_AS((void)parse_distribution(text), InvalidArgument);
}

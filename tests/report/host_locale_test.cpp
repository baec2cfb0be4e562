// A program that uses the library may have any locale: no text of the library follows it.
#include <gtest/gtest.h>

#include <cerrno>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <vector>

#include "core/plain_text.h"
#include "movement/trend.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/movement/movement.h"
#include "tank_datum/report/report.h"

namespace tank_datum::host_locale_test {

/// The locale de_DE, made in a folder of its own, for this process as long as it lives.
class German {
 public:
  German() {
    const std::string made = "localedef --no-archive -i de_DE -f UTF-8 " + folder_.path("de_DE.UTF-8");
    if (std::system(made.c_str()) != 0) return;
    setenv("LOCPATH", folder_.root().c_str(), 1);
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) return;
    std::locale::global(std::locale("de_DE.UTF-8"));
    is_set_ = true;
  }
  ~German() {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
  }
  bool isSet() const { return is_set_; }

 private:
  const TestFolder folder_;
  bool is_set_ = false;
};

std::string refusalOf(const DatumOptions& options) {
  const std::optional<Refusal> refused = firstError(options);
  return refused ? refused->name + " " + refused->value + " " + refused->expected : "";
}

/// Texts of all kinds, with decimals and numbers above a thousand.
std::vector<std::string> texts() {
  std::vector<Station> stations;
  for (int i = 0; i < 36; ++i) {
    Station s;
    s.azimuth = s.direction = i * 2.0 * 3.14159265358979 / 36.0;
    s.x = 31.25 * std::cos(s.azimuth), s.y = 31.25 * std::sin(s.azimuth);
    s.z = 1234.5 + 0.0125 * std::sin(s.azimuth) + 0.004 * std::cos(3 * s.azimuth), s.sigma_z = 0.00075;
    s.flag = StationFlag::Measured;
    stations.push_back(s);
  }
  DatumOptions options;
  options.analysis.facts.height = 12.5;
  const Datum datum = datumOfLevelling(stations, 62.5, options);
  Provenance provenance;
  provenance.options = options;
  DatumOptions refused = options;
  refused.setups.error = -0.5;
  MovementOptions movement;
  movement.estimate_offset = true, movement.azimuth_offset = 0.25;
  return {summary(datum),       datumJson(datum, provenance),
          stationsCsv(datum),   reportPage(datum, provenance),
          refusalOf(refused),   firstError(movement)->value,
          standardLimitsText(), generalText(timesOf({"2024.5"}, 1).front())};
}

TEST(HostLocale, NoTextFollowsIt) {
  const std::vector<std::string> expected = texts();
  const German german;
  ASSERT_TRUE(german.isSet()) << "the package locales is needed";
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", 31.25);
  ASSERT_STREQ(text, "31,25");  // the host's own
  const std::vector<std::string> found = texts();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected[i]) << i;
  EXPECT_NE(found[0].find("radius 31.250 m"), std::string::npos) << found[0];
  EXPECT_EQ(found[4], "setup_error -0.5 0 to 1000 m");
  std::snprintf(text, sizeof text, "%.2f", 31.25);
  EXPECT_STREQ(text, "31,25");  // and it stays the host's
}

TEST(HostLocale, PlainNumbers) {
  const German german;
  ASSERT_TRUE(german.isSet());
  EXPECT_EQ(generalText(1234567.0), "1.23457e+06");
  EXPECT_EQ(generalText(0.25), "0.25");
  EXPECT_EQ(generalText(26000), "26000");
  EXPECT_EQ(fixedText(-0.5), "-0.500000");
  EXPECT_EQ(systemText(ENOENT), "No such file or directory");
  char text[8];
  EXPECT_EQ(snprintfPlain(text, sizeof text, "%.3f", 1234.5), 8);  // as long as it would be
  EXPECT_STREQ(text, "1234.50");
}

}  // namespace tank_datum::host_locale_test

#include "apps/summary.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "apps/errors.h"
#include "apps/recorder.h"

namespace {

class Summary : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::string written() const {
    std::ifstream in(file_);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const std::string file_ =
      testing::TempDir() + "summary_test_" + std::to_string(::getpid()) + ".json";
};

TEST_F(Summary, findings_keep_their_order_their_type_and_every_digit) {
  // RFC 8259; 0.1 + 0.2 needs 17 digits to come back as the same float64.
  apps::write_summary(file_, {{"stones [1]", 5000},
                              {"air_voids [1]", 0.1 + 0.2},
                              {"fractured [1]", 0},
                              {"bitumen", "70/100 \"soft\""}});
  EXPECT_EQ(written(),
            "{\n"
            "  \"stones [1]\": 5000,\n"
            "  \"air_voids [1]\": 0.30000000000000004,\n"
            "  \"fractured [1]\": 0,\n"
            "  \"bitumen\": \"70/100 \\\"soft\\\"\"\n"
            "}\n");
}

TEST_F(Summary, what_is_not_finite_is_refused_and_nothing_is_written) {
  // JSON has no NaN (RFC 8259, section 6); null in its place would hide the trouble.
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(apps::write_summary(file_, {{"height [m]", std::nan("")}}), apps::NotANumber);
  EXPECT_THROW(apps::write_summary(file_, {{"height [m]", -infinite}}), apps::NotANumber);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Summary, text_that_is_not_utf8_does_not_lose_the_summary) {
  // Byte FF is never UTF-8 (RFC 3629); U+FFFD stands in its place.
  apps::write_summary(file_, {{"host", "a\xff"}, {"stones [1]", 3}});
  EXPECT_EQ(written(), "{\n  \"host\": \"a\xEF\xBF\xBD\",\n  \"stones [1]\": 3\n}\n");
}

TEST_F(Summary, a_folder_that_is_not_there_is_an_output_error) {
  // ENOENT of open(2).
  EXPECT_THROW(apps::write_summary(file_ + "/missing/summary.json", {}), apps::OutputError);
}

}  // namespace

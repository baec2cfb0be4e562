#include "io/json_file.h"

#include <gtest/gtest.h>

#include "support/refused.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"

namespace tank_datum::json_file_test {

class JsonFile : public testing::Test {
 protected:
  void write(const std::string& text) const { folder_.file("datum.json", text); }
  std::string refusal() const {
    return refusalOf(Error::Kind::File, [&] { readJson(path_, "epoch", "a datum.json"); });
  }
  const TestFolder folder_;
  const std::string path_ = folder_.path("datum.json");
};

TEST_F(JsonFile, OfTheSchemaWrittenIsRead) {
  write("{\"schema\": 1, \"status\": \"ok\"}");
  EXPECT_EQ(readJson(path_, "epoch", "a datum.json").at("status"), "ok");
}

TEST_F(JsonFile, OfANewerSchemaIsRefused) {
  write("{\"schema\": 99}");
  EXPECT_EQ(refusal(), "epoch: " + path_ + ", schema 99, expected schema 1 or older: a newer version wrote it");
}

TEST_F(JsonFile, ThatIsNoneOfOursIsRefused) {
  EXPECT_NE(refusal().find("No such file or directory, expected a datum.json"), std::string::npos);
  for (const char* text : {"", "{", "[1]", "{}", "{\"schema\": \"one\"}"}) {
    write(text);
    EXPECT_NE(refusal().find("expected a datum.json"), std::string::npos) << text;
  }
}

}  // namespace tank_datum::json_file_test

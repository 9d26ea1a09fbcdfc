#include "protocol/contract/fields_json.h"

#include <gtest/gtest.h>

namespace stanok::protocol {
namespace {

Fields some_fields() {
  return {{"b", true},
          {"a", 1.0},
          {"count", count_field(3U)},
          {"none", {}},
          {"text", "say \"yes\"\n\xff"},
          {"list", FieldList{0.1, "x", FieldList{}}},
          {"inner", Fields{{"tenth", 0.1}}},
          {"empty", Fields{}}};
}

TEST(FieldsJson, KeepsTheOrderAndTellsNumbersFromWholeOnes) {
  const nlohmann::ordered_json json = fields_json(some_fields());
  EXPECT_EQ(json.begin().key(), "b");
  EXPECT_TRUE(json.at("a").is_number_float());
  EXPECT_TRUE(json.at("count").is_number_integer());
  EXPECT_TRUE(json.at("none").is_null());
  EXPECT_EQ(json.at("list").size(), 3U);
  EXPECT_EQ(json.at("inner").at("tenth"), 0.1);
  EXPECT_TRUE(json.at("empty").is_object());
}

TEST(FieldsJson, ALineIsTheSameObject) {
  std::string line;
  append_json_line(line, some_fields());
  EXPECT_EQ(line,
            "{\"b\":true,\"a\":1,\"count\":3,\"none\":null,"
            "\"text\":\"say \\\"yes\\\"\\u000a\xEF\xBF\xBD\",\"list\":[0.1,\"x\",[]],"
            "\"inner\":{\"tenth\":0.1},\"empty\":{}}\n");
}

}  // namespace
}  // namespace stanok::protocol

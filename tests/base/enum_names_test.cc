// Names of enumerations in both directions.
#include "base/enum_names.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace stanok {
namespace {

enum class Shape : std::uint8_t { round, square, flat };
enum class Answer : std::uint8_t { yes = 1, no };

constexpr auto shape_names = enum_names<Shape>(
    {{Shape::flat, "flat"}, {Shape::round, "round"}, {Shape::square, "a square"}});
constexpr auto answer_names = enum_names<Answer, 1>({{Answer::yes, "yes"}, {Answer::no, "no"}});

TEST(EnumNames, NameEveryValueWhateverTheOrderOfRows) {
  EXPECT_EQ(shape_names[Shape::round], "round");
  EXPECT_EQ(shape_names[Shape::square], "a square");
  EXPECT_EQ(shape_names[Shape::flat], "flat");
  EXPECT_EQ(answer_names[Answer::yes], "yes");
  EXPECT_EQ(answer_names[Answer::no], "no");
}

TEST(EnumNames, FindTheValueOfAName) {
  EXPECT_EQ(shape_names.value("a square"), Shape::square);
  EXPECT_EQ(answer_names.value("no"), Answer::no);
  EXPECT_EQ(shape_names.value("square"), std::nullopt);
  EXPECT_EQ(shape_names.value(""), std::nullopt);
}

TEST(EnumNames, HaveNothingForWhatIsNoValue) {
  EXPECT_EQ(shape_names[static_cast<Shape>(3)], "");
  EXPECT_EQ(answer_names[static_cast<Answer>(0)], "");
}

// What the compiler is asked so that no value is forgotten.
TEST(EnumNames, AreCompleteOrDoNotCompile) {
  static_assert(EnumNames<Shape, 3>::is_complete<0>());
  static_assert(!EnumNames<Shape, 2>::is_complete<0>());
  static_assert(EnumNames<Answer, 2>::is_complete<1>());
  static_assert(!EnumNames<Answer, 1>::is_complete<1>());
}

}  // namespace
}  // namespace stanok

#include "base/fixed_text.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace stanok {
namespace {

static_assert(std::is_trivially_copyable_v<FixedText<8>>);

TEST(FixedText, IsEmptyAtFirst) {
  const FixedText<8> text;
  EXPECT_TRUE(text.empty());
  EXPECT_EQ(text.view(), "");
}

TEST(FixedText, HoldsATextThatFits) {
  EXPECT_EQ(FixedText<8>("E7001").view(), "E7001");
  EXPECT_EQ(FixedText<8>("1234567").view(), "1234567");
}

TEST(FixedText, CutsATextThatIsTooLongAndStillEndsWithZero) {
  const FixedText<8> text("123456789");
  EXPECT_EQ(text.view(), "1234567");
  EXPECT_EQ(text.characters.back(), '\0');
}

TEST(FixedText, EndsAtAnEmbeddedZero) {
  EXPECT_EQ(FixedText<8>(std::string_view("ab\0cd", 5)).view(), "ab");
}

TEST(FixedText, IsKnownToTheCompiler) {
  static_assert(FixedText<4>("G1").view() == "G1");
  static_assert(FixedText<4>("").empty());
}

}  // namespace
}  // namespace stanok

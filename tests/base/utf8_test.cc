#include "base/utf8.h"

#include <gtest/gtest.h>

#include "base/fixed_text.h"

namespace stanok {
namespace {

// "Деталь" in CP1251, and in UTF-8.
constexpr std::string_view cp1251 = "\xC4\xE5\xF2\xE0\xEB\xFC";
constexpr std::string_view utf8 = "\xD0\x94\xD0\xB5\xD1\x82\xD0\xB0\xD0\xBB\xD1\x8C";

std::string replacements(int count) {
  std::string text;
  while (count-- > 0) text += replacement_character;
  return text;
}

struct RepairCase {
  std::string_view bytes;
  std::string text;
};

// Boundaries of the table in RFC 3629, section 4.
TEST(Utf8, ReplacesWhatIsNoCharacterAndNothingElse) {
  const RepairCase cases[] = {
      {"", ""},
      {"G1 X1", "G1 X1"},
      {utf8, std::string(utf8)},
      {"\xC2\x80 \xDF\xBF \xE0\xA0\x80 \xED\x9F\xBF \xEE\x80\x80 \xF0\x90\x80\x80 \xF4\x8F\xBF\xBF",
       "\xC2\x80 \xDF\xBF \xE0\xA0\x80 \xED\x9F\xBF \xEE\x80\x80 \xF0\x90\x80\x80 "
       "\xF4\x8F\xBF\xBF"},
      {cp1251, replacements(6)},
      {"a\xFF\x62", "a" + replacements(1) + "b"},
      {"12345678\xD0", "12345678" + replacements(1)},  // cut behind the first byte
      {"\xE2\x82", replacements(2)},                   // cut behind the second
      {"\xF0\x9F\x94 x", replacements(3) + " x"},      // behind the third
      {"\xC0\xAF", replacements(2)},                   // overlong
      {"\xE0\x9F\xBF", replacements(3)},               // overlong
      {"\xED\xA0\x80", replacements(3)},               // a surrogate
      {"\xF4\x90\x80\x80", replacements(4)},           // beyond U+10FFFF
      {"\x80", replacements(1)},
  };
  for (const RepairCase& given : cases) {
    EXPECT_EQ(valid_utf8(given.bytes), given.text);
    EXPECT_EQ(is_utf8(given.bytes), given.bytes == given.text) << given.text;
    EXPECT_TRUE(is_utf8(valid_utf8(given.bytes)));
  }
}

TEST(Utf8, EveryTextOfFewBytesIsValidWhenItIsRepaired) {
  const std::string bytes = {'a',    '\0',   '\x80', '\xBF', '\xC1', '\xD0',
                             '\xE0', '\xED', '\xF0', '\xF4', '\xFF'};
  for (const char a : bytes) {
    for (const char b : bytes) {
      for (const char c : bytes) {
        for (const char d : bytes) {
          const std::string text{a, b, c, d};
          EXPECT_TRUE(is_utf8(valid_utf8(text)));
          EXPECT_EQ(valid_utf8(valid_utf8(text)), valid_utf8(text));
        }
      }
    }
  }
}

TEST(Utf8, CutsBetweenCharacters) {
  const std::string text = "a" + std::string(utf8) + "\xE2\x82\xAC\xF0\x9F\x94\xA7";
  for (std::size_t bytes = 0; bytes <= text.size() + 1; ++bytes) {
    const std::string_view cut = cut_to(text, bytes);
    EXPECT_LE(cut.size(), bytes);
    EXPECT_TRUE(is_utf8(cut)) << bytes;
    EXPECT_TRUE(text.starts_with(cut));
    EXPECT_GT(cut.size() + 4, std::min(bytes, text.size())) << "not shorter than need be";
  }
  EXPECT_EQ(cut_to(cp1251, 3), cp1251.substr(0, 3)) << "bytes that are no text are kept";
}

TEST(Utf8, CountsCharacters) {
  EXPECT_EQ(character_count(utf8), 6u);
  EXPECT_EQ(offset_of_character(utf8, 2), 4u);
  EXPECT_EQ(offset_of_character(utf8, 6), utf8.size());
  EXPECT_EQ(offset_of_character(utf8, 60), utf8.size());
}

TEST(Utf8, AFixedTextHoldsWholeCharacters) {
  EXPECT_EQ(FixedText<8>(utf8).view(), utf8.substr(0, 6));
  EXPECT_EQ(FixedText<7>("abc").append(utf8).view(), "abc\xD0\x94");
  static_assert(FixedText<4>(utf8).view() == utf8.substr(0, 2));
}

}  // namespace
}  // namespace stanok

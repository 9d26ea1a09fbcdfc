#include "config/text/text_encoding.h"

#include <gtest/gtest.h>

#include "base/utf8.h"

namespace stanok::config {
namespace {

struct EncodedText {
  const char* encoding;
  std::string bytes;
};

// "Деталь" as the tables of the Unicode consortium have it.
TEST(TextEncoding, IsConvertedToUtf8) {
  const std::string text = "(\u0414\u0435\u0442\u0430\u043B\u044C) G1 X1\r\n";
  const EncodedText encoded[] = {
      {"cp1251", "(\xC4\xE5\xF2\xE0\xEB\xFC) G1 X1\r\n"},
      {"CP866", "(\x84\xA5\xE2\xA0\xAB\xEC) G1 X1\r\n"},
      {"koi8-r", "(\xE4\xC5\xD4\xC1\xCC\xD8) G1 X1\r\n"},
      {"iso-8859-5", "(\xB4\xD5\xE2\xD0\xDB\xEC) G1 X1\r\n"},
  };
  for (const EncodedText& one : encoded) EXPECT_EQ(text_from(one.bytes, one.encoding), text);
}

TEST(TextEncoding, BothAlphabetsMayStandInOneFolder) {
  const std::string text = "(\u0414\u0435\u0442\u0430\u043B\u044C)";
  EXPECT_EQ(text_from(text, "cp1251"), text);
  EXPECT_EQ(text_from(text, ""), text);
  EXPECT_EQ(text_from("(\xC4)", ""), "(\xC4)") << "no encoding is guessed";
}

TEST(TextEncoding, AByteOrderMarkOfUtf16IsBelieved) {
  using namespace std::string_literals;
  EXPECT_EQ(text_from("\xFF\xFEG\0\x31\0\x14\x04"s, ""), "G1\u0414");
  EXPECT_EQ(text_from("\xFE\xFF\0G\0\x31\x04\x14"s, "cp1251"), "G1\u0414");
  EXPECT_TRUE(is_utf8(text_from("\xFF\xFEG\0\x31"s, ""))) << "cut within a character";
  EXPECT_TRUE(is_utf8(text_from("\xFF\xFE\x00\xD8G\0"s, ""))) << "half a pair";
}

// 0x98 has no character in CP1251.
TEST(TextEncoding, WhatTheEncodingDoesNotHaveIsReplaced) {
  EXPECT_EQ(text_from("\xC4\x98X1\x98", "cp1251"), "\u0414\uFFFDX1\uFFFD");
}

TEST(TextEncoding, LongTextsAreWhole) {
  std::string bytes;
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    bytes += "\xC4X";
    text += "\u0414X";
  }
  EXPECT_EQ(text_from(bytes, "cp1251"), text);
}

TEST(TextEncoding, ProgramsNeedAnEncodingThatHasAscii) {
  for (const char* name : {"cp1251", "CP866", "koi8-r", "ISO-8859-1", "windows-1252", "utf-8"})
    EXPECT_TRUE(is_encoding_of_programs(name)) << name;
  for (const char* name : {"", "cp12510", "UTF-16", "UTF-7", "EBCDIC-US", "../../etc/passwd"})
    EXPECT_FALSE(is_encoding_of_programs(name)) << name;
}

}  // namespace
}  // namespace stanok::config

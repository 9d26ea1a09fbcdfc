// The list of feed laws: each is whole, and what reads, keeps and shows laws takes it from there.
#include "lang/feed_law/law_types.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "lang/feed_law/feed_law_reader.h"
#include "lang/feed_law/law_reader.h"

namespace stanok::lang {
namespace {

TEST(LawTypes, EachIsWhole) {
  std::set<std::string_view> names;
  for (const LawType& type : law_types()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name << " is there twice";
    EXPECT_NE(type.kind, FeedLaw::Kind::off);
    EXPECT_EQ(type.read != nullptr, !type.forms.empty()) << type.name;
    EXPECT_NE(type.is_plausible, nullptr) << type.name;
    EXPECT_NE(type.values, nullptr) << type.name;
    EXPECT_FALSE(type.is_plausible({})) << type.name << " takes a law without values";
    for (const LawForm& form : type.forms) EXPECT_EQ(&law_type_of(form), &type);
  }
  EXPECT_EQ(find_law_type(FeedLaw::Kind::off), nullptr);
  EXPECT_EQ(find_law_type(FeedLaw::Kind::linear)->name, "linear");
}

// Whatever the values are, a law that its words make is one that a saved text may bring, unless its
// step follows from the block.
TEST(LawTypes, ALawThatWasReadIsPlausible) {
  for (const LawForm& form : law_forms()) {
    LawWords words;
    for (const LawAddress address : form.must()) {
      words.set |= address_bit(address);
      words.values[address] = 2.0;
    }
    words.values[LawAddress::feed_max] = 8.0;
    words.values[LawAddress::feed_last] = 8.0;
    const auto law = read_feed_law({.resolution_mm = 0.001}, form, words, LawScope::block);
    ASSERT_TRUE(law.has_value()) << form.law << ": " << law.error().message;
    const bool follows =
        (words.set & address_bit(LawAddress::path_step)) == 0 && law->kind == FeedLaw::Kind::linear;
    EXPECT_EQ(law_type_of(form).is_plausible(*law), !follows) << form.law;
    EXPECT_EQ(law->gives_feed(), law_type_of(form).takes_feed.empty());
    EXPECT_FALSE(law_type_of(form).values(*law).empty());
  }
}

TEST(LawReader, TheFirstReasonStands) {
  const LawSurroundings around{.length_unit = 25.4, .resolution_mm = 0.001};
  LawWords words;
  words.set = address_bit(LawAddress::stand) | address_bit(LawAddress::cut);
  words.values[LawAddress::stand] = 2.0;
  words.values[LawAddress::cut] = -1.0;
  LawReader reader(around, words, LawScope::block);
  EXPECT_DOUBLE_EQ(reader.length(LawAddress::stand), 50.8);
  EXPECT_FALSE(reader.failed());
  static_cast<void>(reader.length(LawAddress::cut));
  reader.fail("E4341", LawAddress::stand, "a later reason", "", "");
  const auto law = reader.result();
  ASSERT_FALSE(law.has_value());
  EXPECT_EQ(law.error().code, "E4335");
}

}  // namespace
}  // namespace stanok::lang

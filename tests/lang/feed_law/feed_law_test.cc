// Feed laws: which addresses make a law, what their values must be, how long a law lasts. Expected
// laws follow from the definitions of the addresses (docs/reference/language.md, "Feed laws"),
// worked out here by hand.
#include <gmock/gmock.h>

#include <random>

#include "lang/feed_law/feed_law_numbers.h"
#include "lang/feed_law/feed_law_words.h"
#include "lang/words/named_address.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

using ::testing::HasSubstr;

class FeedLaws : public ProgramTest {
 protected:
  // The laws of a run without error, in order.
  std::vector<FeedLawChange> laws(const std::string& text) {
    run(text);
    EXPECT_EQ(error.code, "") << to_text(error);
    return all<FeedLawChange>();
  }
};

// Every set of addresses that the language knows, from the table of the document.
const std::vector<std::vector<std::string>>& right_sets() {
  static const std::vector<std::vector<std::string>> sets = {
      {"S_n", "dS", "dl"},
      {"S_n", "S_k", "dS"},
      {"S_n", "S_k", "dS", "dl"},
      {"Smin", "dS", "dl", "n_s"},
      {"Smin", "Smax", "dS", "dl"},
      {"L_A", "L_B"},
      {"n_n", "dn", "S_n", "dS", "dl"},
      {"n_n", "n_k", "S_n", "S_k", "dS"},
      {"n_n", "n_k", "S_n", "S_k", "dS", "dl"},
      {"v_n", "dv", "S_n", "dS", "dl"},
      {"v_n", "v_k", "S_n", "S_k", "dS"},
      {"v_n", "v_k", "S_n", "S_k", "dS", "dl"},
  };
  return sets;
}

std::vector<std::string> law_addresses() {
  std::vector<std::string> names;
  for (const std::string_view name : named_addresses()) {
    if (name != "SPOS") names.emplace_back(name);
  }
  return names;
}

bool is_right(std::vector<std::string> set) {
  std::sort(set.begin(), set.end());
  return std::any_of(right_sets().begin(), right_sets().end(), [&](std::vector<std::string> right) {
    std::sort(right.begin(), right.end());
    return right == set;
  });
}

// Of all 32767 mixes the known ones are laws; of every other the error names an address and leads
// to a law: a missing one is not there, one too many is.
TEST_F(FeedLaws, AreTheMixesOfTheTableAndNoOthers) {
  const std::vector<std::string> names = law_addresses();
  ASSERT_EQ(names.size(), enum_count<LawAddress>());
  for (unsigned bits = 1; bits < 1U << names.size(); ++bits) {
    BlockWords words;
    std::vector<std::string> set;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if ((bits >> i & 1U) == 0) continue;
      words.named.push_back({names[i], 1.0});
      set.push_back(names[i]);
    }
    const auto form = form_of(law_words_of(words));
    ASSERT_EQ(form.has_value(), is_right(set)) << ::testing::PrintToString(set);
    if (form) continue;
    const BlockFault& fault = form.error();
    const bool missing = fault.code == "E4330";
    ASSERT_TRUE(missing || fault.code == "E4331" || fault.code == "E4332") << fault.code;
    const auto named = std::find(set.begin(), set.end(), fault.word.name);
    ASSERT_NE(named, set.end()) << "the place is a word of the block";
    ASSERT_THAT(fault.message, HasSubstr("`" + fault.word.name + "` = 1"));
    ASSERT_FALSE(fault.help.empty());
    if (!missing) continue;
    const std::string lacking = fault.label.substr(4, fault.label.size() - 5);
    ASSERT_EQ(std::find(set.begin(), set.end(), lacking), set.end()) << fault.message;
    ASSERT_NE(std::find(names.begin(), names.end(), lacking), names.end()) << fault.message;
  }
}

TEST_F(FeedLaws, MissOneAddressByItsName) {
  for (const std::vector<std::string>& right : right_sets()) {
    for (const std::string& left_out : right) {
      BlockWords words;
      std::vector<std::string> rest;
      for (const std::string& name : right) {
        if (name == left_out) continue;
        words.named.push_back({name, 1.0});
        rest.push_back(name);
      }
      const auto form = form_of(law_words_of(words));
      if (is_right(rest)) continue;
      ASSERT_FALSE(form.has_value());
      EXPECT_EQ(form.error().code, "E4330") << form.error().message;
    }
  }
}

// `dn = 2;` would be a block.
TEST_F(FeedLaws, LendTheirAddressesToNoVariable) {
  EXPECT_EQ(error_code("num dn = 1;\nM30\n"), "E3003");
  EXPECT_EQ(error_code("void f (num SMIN) {}\nM30\n"), "E3003");
}

TEST_F(FeedLaws, OfTheSpindleNeedOneThatIsNoAxis) {
  channel.axes[4].spindle = 1;
  EXPECT_EQ(error_code("M902 H1=1\nn_n=100 dn=1 S_n=60 dS=1 dl=1\nM30\n"), "E4056");
}

TEST_F(FeedLaws, DoNotExistOnAMasterChannel) {
  channel = master_channel();
  EXPECT_EQ(error_code("L_A=1 L_B=2\nM30\n"), "E4009");
}

// Steps of feed are hundredths of an inch per minute: 0.1 mm/min is no number of inches.
TEST_F(FeedLaws, AreInInchesLikeTheirProgram) {
  const auto inch = laws("G20 G1 F1 Smin=2 Smax=4 dS=0.5 dl=0.05\nM30\n");
  ASSERT_EQ(inch.size(), 2u);
  EXPECT_NEAR(inch[0].law.feed_first, 50.8, 1e-12);
  EXPECT_NEAR(inch[0].law.feed_last, 101.6, 1e-12);
  EXPECT_NEAR(inch[0].law.feed_step, 12.7, 1e-12);
  EXPECT_NEAR(inch[0].law.path_step_mm, 1.27, 1e-12);
  EXPECT_EQ(inch[0].law.steps, 4);
  EXPECT_EQ(error_code("G20 S_n=2 dS=0.1 dl=0.05\nM30\n"), "");
  EXPECT_EQ(error_code("G20 G95 S_n=0.01 dS=0.0005 dl=0.05\nM30\n"), "");
  EXPECT_EQ(error_code("G20 S_n=2 dS=0.105 dl=0.05\nM30\n"), "E4336");
}

// An increment of 0.005 mm takes 0.015, not 0.012; a channel whose increment is not known takes
// both.
TEST_F(FeedLaws, HaveLengthsInIncrementsOfTheirChannel) {
  channel.finest_resolution_mm = 0.005;
  EXPECT_EQ(error_code("S_n=60 dS=1 dl=0.015\nM30\n"), "");
  EXPECT_EQ(error_code("S_n=60 dS=1 dl=0.012\nM30\n"), "E4336");
  channel.finest_resolution_mm = 0.0;
  EXPECT_EQ(error_code("S_n=60 dS=1 dl=0.012\nM30\n"), "");
}

// Multiples as decimal numbers have them: k * 0.1 is none of them to the bit.
TEST_F(FeedLaws, TakeEveryMultipleOfTheirSteps) {
  std::mt19937 random(20261121);
  for (int trial = 0; trial < 300; ++trial) {
    const auto feed = static_cast<int>(random() % 100000 + 1);
    const auto way = static_cast<int>(random() % 1000000 + 1);
    char text[160];
    std::snprintf(text, sizeof text, "S_n=60 dS=%d.%d dl=%d.%03d\nM30\n", feed / 10, feed % 10,
                  way / 1000, way % 1000);
    EXPECT_EQ(error_code(text), "") << text << to_text(error);
    std::snprintf(text, sizeof text, "S_n=60 dS=%d.%d01 dl=1\nM30\n", feed / 10, feed % 10);
    EXPECT_EQ(error_code(text), "E4336") << text;
    std::snprintf(text, sizeof text, "S_n=60 dS=1 dl=%d.%03d01\nM30\n", way / 1000, way % 1000);
    EXPECT_EQ(error_code(text), "E4336") << text;
  }
}

// The law of the block lies directly before its motion, whatever else the block says.
TEST_F(FeedLaws, OfABlockStandDirectlyBeforeItsMotion) {
  const auto list =
      run("G1 X1 S_n=60 dS=1 dl=1 F100 M62 P1 S500 M3 M8\nG2 X1 I5 Smin=30 dS=1 dl=1 n_s=2\nM30\n");
  int found = 0;
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    const auto* const change = std::get_if<FeedLawChange>(&list[i].payload);
    if (change == nullptr) continue;
    ++found;
    EXPECT_TRUE(change->of_next_block);
    const auto* const move = std::get_if<Move>(&list[i + 1].payload);
    ASSERT_NE(move, nullptr);
    EXPECT_EQ(move->feed, change->law.feed_first);
    EXPECT_EQ(list[i].block, list[i + 1].block);
  }
  EXPECT_EQ(found, 2) << to_text(error);
}

// Plain lines take another way through the interpreter: there too F ends a law, and a move under a
// law has its first feed.
TEST_F(FeedLaws, AreKnownToPlainLines) {
  const std::string with_law = "F50 S_n=60 dS=1 dl=1\n";
  const std::string plain = "G1 X1\nX2\nX3 F100\nX4\nM30\n";
  for (const std::string& text :
       {with_law + plain, with_law + "G1 X=1\nX=2\nX=3 F=100\nX=4\nM30\n"}) {
    const auto changes = laws(text);
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[1].law, FeedLaw{});
    std::vector<double> feeds;
    for (const Move& move : all<Move>()) feeds.push_back(move.feed);
    EXPECT_EQ(feeds, (std::vector<double>{60, 60, 100, 100}));
  }
}

TEST_F(FeedLaws, EndWithTheFeedModeAndWithAFeedThatWasNeverKnown) {
  EXPECT_EQ(error_code("G1 S_n=60 dS=1 dl=1\nX1\n#feedlaw (off)\nX2\nM30\n"), "E4020");
  EXPECT_EQ(error.place.line, 4);
  EXPECT_EQ(error_code("G1 F50 S_n=60 dS=1 dl=1\nX1\nG93 X2 F1\nG94 X3\nM30\n"), "E4020");
  EXPECT_EQ(error.place.line, 4);
  EXPECT_EQ(error_code("G1 F50 S_n=60 dS=1 dl=1\nG95\nX1\nM30\n"), "E4020");
  EXPECT_EQ(error.place.line, 3);
  const auto list = run("G1 F50 S_n=60 dS=1 dl=1\nG93\nG0 X1\nM30\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(std::get<FeedLawChange>(list[1].payload).law, FeedLaw{});
  EXPECT_TRUE(std::holds_alternative<Move>(list[2].payload));
}

TEST_F(FeedLaws, AreNotEndedByTheModeThatIsActiveAlready) {
  EXPECT_EQ(laws("G94 S_n=60 dS=1 dl=1\nG94\nG1 X1\n").size(), 2u);
}

// Two runs of one interpreter: the second begins without law.
TEST_F(FeedLaws, DoNotOutliveTheirProgram) {
  run("G1 F50 S_n=60 dS=1 dl=1\nM30\n");
  files.texts["next.nc"] = "G1 X1 F20\nX2\nM30\n";
  auto program = compile("next.nc", files, &channel, warnings);
  ASSERT_TRUE(program.has_value());
  commands.clear();
  interpreter->start(*program, start_B);
  drain();
  EXPECT_TRUE(all<FeedLawChange>().empty());
  EXPECT_EQ(all<Move>().at(1).feed, 20.0);
}

FeedLaw random_law(std::mt19937& random) {
  const auto value = [&] { return static_cast<double>(random() % 1000000 + 1) / 7.0; };
  FeedLaw law;
  law.kind = static_cast<FeedLaw::Kind>(random() % 5);
  if (law.kind == FeedLaw::Kind::off) return law;
  law.feed_mode = random() % 2 == 0 ? FeedMode::per_minute : FeedMode::per_revolution;
  if (law.kind != FeedLaw::Kind::interrupted) law.feed_first = value();
  law.feed_step = value();
  law.falls = random() % 2 == 0;
  law.path_step_mm = value();
  law.feed_last = value();
  law.steps = static_cast<int>(random() % 1000 + 1);
  law.stand_mm = value();
  law.cut_mm = value();
  law.speed = static_cast<FeedLaw::Speed>(random() % 3);
  law.speed_first = value();
  law.speed_step = -value();
  law.speed_last = value();
  const bool curve = law.kind == FeedLaw::Kind::curve;
  for (std::size_t i = curve ? random() % 20 + 2 : 0; i > 0; --i) {
    law.curve.push_back({value(), value(), value()});
  }
  return law;
}

TEST_F(FeedLaws, SurviveAsNumbersToTheBit) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 500; ++trial) {
    const FeedLaw law = random_law(random);
    auto numbers = numbers_of(law);
    const auto read = law_of_numbers(numbers);
    ASSERT_TRUE(read.has_value());
    ASSERT_EQ(*read, law);
    numbers.pop_back();
    ASSERT_FALSE(law_of_numbers(numbers).has_value()) << "a number is missing";
    numbers = numbers_of(law);
    numbers[0] = 7.0;
    ASSERT_FALSE(law_of_numbers(numbers).has_value()) << "no such law";
  }
}

TEST_F(FeedLaws, AreNotTakenFromNumbersThatNoBlockCouldSay) {
  FeedLaw law;
  law.kind = FeedLaw::Kind::linear;
  law.feed_first = 60.0;
  law.feed_step = 1.0;
  law.path_step_mm = 1.0;
  EXPECT_TRUE(law_of_numbers(numbers_of(law)));
  law.path_step_mm = 0.0;
  EXPECT_FALSE(law_of_numbers(numbers_of(law)));
  law.path_step_mm = 1.0;
  law.feed_first = 0.0;
  EXPECT_FALSE(law_of_numbers(numbers_of(law)));
  law.feed_first = 60.0;
  law.feed_step = -1.0;
  EXPECT_FALSE(law_of_numbers(numbers_of(law)));
}

TEST_F(FeedLaws, OfADescribedChannelLetterAreThoseOfItsAddress) {
  channel.address_alias = {{'E', "dS"}};
  EXPECT_EQ(laws("S_n=60 E0.5 dl=1\nM30\n"), laws("S_n=60 dS=0.5 dl=1\nM30\n"));
  EXPECT_EQ(error_code("S_n=60 E0.5 dS=0.5 dl=1\nM30\n"), "E4001");
}

// The E of a macro call is its argument #8.
TEST_F(FeedLaws, LeaveTheLettersOfMacroCallsAlone) {
  channel.address_alias = {{'E', "dS"}};
  const auto list = messages("G65 P100 E7\nM30\nO100\n(DEBUG,#8)\nM99\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0], "7.000000");
}

TEST_F(FeedLaws, AreWhatABlockSearchLeavesInForce) {
  SearchCollector collector;
  FeedLaw law;
  law.kind = FeedLaw::Kind::linear;
  law.feed_first = 60.0;
  collector.take({{}, 1, FeedLawChange{law, false}});
  collector.take({{}, 2, FeedLawChange{FeedLaw{}, true}});
  EXPECT_EQ(collector.state().feed_law, law);
}

}  // namespace
}  // namespace stanok::lang::testing

// Tool, spindles and distance to go, as a status shows them.
#include "daemon/report/channel_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace stanok::daemon {
namespace {

using nlohmann::json;

TEST(ChannelDisplay, NameTheToolOfTheTable) {
  channels::TablesConfig tables;
  tables.tools.resize(2);
  tables.tools[0].number = 5;
  tables.tools[0].name = "mill 10";
  tables.tools[1].number = 5;
  tables.tools[1].edge = 2;
  EXPECT_EQ(tool_at_work({5, 1}, tables), (json{{"number", 5}, {"edge", 1}, {"name", "mill 10"}}));
  EXPECT_TRUE(tool_at_work({5, 2}, tables)["name"].is_null());
  EXPECT_TRUE(tool_at_work({0, 1}, tables)["name"].is_null());
}

TEST(ChannelDisplay, TellSpindlesAsCommandedAndAsMeasured) {
  channels::ChannelConfig config;
  config.spindles = {1, 2, 3};
  channels::ChannelOutput output;
  output.process.spindles[0] = {.id = 1, .rev_per_min = 1200.0};
  output.process.spindles[1] = {.id = 2, .rev_per_min = -50.0};
  output.process.spindles[2] = {.id = 3, .rev_per_min = 0.0};
  drives::BusStatus bus;
  bus.axes.resize(2);
  bus.axes[0].axis = "S1";
  bus.axes[0].in_contact = true;
  bus.axes[0].feedback.velocity = 1198.5;
  bus.axes[0].feedback.power_w = 450.0;
  bus.axes[1].axis = "S2";
  const json spindles = spindles_of(config, output, bus);
  EXPECT_EQ(spindles[0], (json{{"id", 1},
                               {"direction", "clockwise"},
                               {"commanded_rev_min", 1200.0},
                               {"actual_rev_min", 1198.5},
                               {"power_w", 450.0}}));
  EXPECT_EQ(spindles[1]["direction"], "counter-clockwise");
  EXPECT_TRUE(spindles[1]["actual_rev_min"].is_null()) << "its drive does not answer";
  EXPECT_EQ(spindles[2]["direction"], "stopped");
}

TEST(ChannelDisplay, TellForWhatAChannelWaits) {
  channels::ChannelOutput output;
  output.id = 2;
  EXPECT_TRUE(wait_of(output).is_null());
  output.wait = {.cause = channels::WaitCause::mark, .number = 5, .channels = 0b1110};
  EXPECT_EQ(wait_of(output), (json{{"for", "mark"}, {"number", 5}, {"channels", {1, 3}}}));
  output.wait = {.cause = channels::WaitCause::dwell};
  EXPECT_EQ(wait_of(output),
            (json{{"for", "dwell"}, {"number", nullptr}, {"channels", json::array()}}));
}

TEST(ChannelDisplay, FindWorkOffsetAndCoolantAmongTheCodes) {
  EXPECT_EQ(work_offset_of({"G1", "G54", "G90"}), "G54");
  EXPECT_EQ(work_offset_of({"G50", "G59.3"}), "G59.3");
  EXPECT_TRUE(work_offset_of({"G1", "G5", "G52", "G5.1"}).is_null());
  EXPECT_EQ(coolant_of({"M3", "M7", "M8"}), (json{"mist", "flood"}));
  EXPECT_EQ(coolant_of({"M9"}), json::array());
}

TEST(ChannelDisplay, GoToTheEndOfTheBlock) {
  channels::ChannelConfig config;
  config.words = {"X", "Y"};
  channels::ChannelOutput output;
  output.point_W[0].value = 2.0;
  channels::SituationReport situation;
  EXPECT_TRUE(distance_to_go(config, output, situation).is_null()) << "no program runs";
  output.running = true;
  EXPECT_EQ(distance_to_go(config, output, situation), (json{{"X", 0.0}, {"Y", 0.0}}));
  situation.end_W = motion::Point{10.0, -1.0};
  EXPECT_EQ(distance_to_go(config, output, situation), (json{{"X", 8.0}, {"Y", -1.0}}));
}

// On a lathe in G7 the word X is a diameter, scaled by 2 and mirrored at X = 3 (radius) the part
// system has w = -2 p + 12: for w = 5 p is 3.5, the word 7.
TEST(ChannelDisplay, ShowsTheWordsThatLeadThere) {
  channels::ChannelConfig config;
  config.words = {"X", "Z"};
  channels::ChannelOutput output;
  output.point_W[0].value = 5.0;
  output.point_W[1].value = -4.0;
  lang::MeaningTerms terms;
  terms.geometry = {AxisIndex(0), AxisIndex(), AxisIndex(1)};
  terms.gain[0] = -2.0;
  terms.shift[0] = 12.0;
  lang::Meaning meaning;
  meaning.terms = std::make_shared<const lang::MeaningTerms>(terms);
  EXPECT_EQ(position_of(config, output, meaning), (json{{"X", 3.5}, {"Z", -4.0}}));
  EXPECT_EQ(diameters_of(config, meaning), json::array());
  meaning.codes[lang::Group::diameter] = lang::g(7);
  EXPECT_EQ(position_of(config, output, meaning), (json{{"X", 7.0}, {"Z", -4.0}}));
  EXPECT_EQ(point_of(config, output), (json{{"X", 5.0}, {"Z", -4.0}}));
  EXPECT_EQ(diameters_of(config, meaning), json{"X"});
}

// A spindle that turns by hand, coolant that was switched on by hand: the program says nothing of
// them.
TEST(ChannelDisplay, ShowsSpindleAndCoolantAsTheyWereOrderedLast) {
  lang::Meaning meaning;
  meaning.codes = lang::default_codes(lang::ChannelKind::mill);
  channels::ChannelOutput output;
  output.process.spindles[0] = {.id = 1, .target_rev_per_min = -500.0};
  output.coolant.flood = true;
  const auto names = lang::names_of(codes_in_effect(meaning, output), 'M');
  EXPECT_THAT(names, ::testing::IsSupersetOf({"M4", "M8"}));
  EXPECT_THAT(names, ::testing::Not(::testing::Contains("M5")));
}

}  // namespace
}  // namespace stanok::daemon

// Records of `stanok interpret`: what a feed law looks like there.
#include "jobs/interpret/record_fields.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "protocol/contract/fields_json.h"

namespace stanok::jobs {
namespace {

using nlohmann::json;

json record_of(const lang::FeedLaw& law, bool of_next_block) {
  lang::Command command;
  command.origin.line = 12;
  command.payload = lang::FeedLawChange{law, of_next_block};
  return protocol::fields_json(record_fields(command, nullptr, {"X", "Z"}));
}

TEST(RecordFields, OfALinearLawHasItsStepsWithSign) {
  lang::FeedLaw law;
  law.kind = lang::FeedLaw::Kind::linear;
  law.feed_first = 60.0;
  law.feed_step = 0.5;
  law.falls = true;
  law.path_step_mm = 0.05;
  EXPECT_EQ(record_of(law, true), json::parse(R"({"line":12,"kind":"feed_law","of_next_block":true,
    "feed_law":{"law":"linear","feed_unit":"mm/min","feed_first":60.0,"feed_step":-0.5,
                "path_step":0.05}})"));
}

TEST(RecordFields, OfALawOfSpeedsSaysWhereTheyEnd) {
  lang::FeedLaw law;
  law.kind = lang::FeedLaw::Kind::linear;
  law.feed_mode = lang::FeedMode::per_revolution;
  law.feed_first = 0.25;
  law.feed_step = 0.125;
  law.feed_last = 0.5;
  law.speed = lang::FeedLaw::Speed::m_per_min;
  law.speed_first = 100.0;
  law.speed_last = 150.0;
  EXPECT_EQ(record_of(law, false)["feed_law"],
            json::parse(R"({"law":"linear","feed_unit":"mm/rev","feed_first":0.25,
    "feed_step":0.125,"feed_last":0.5,"speed_unit":"m/min","speed_first":100.0,
    "speed_last":150.0})"));
}

TEST(RecordFields, OfTheOtherLawsHasWhatTheyHave) {
  lang::FeedLaw law;
  EXPECT_EQ(record_of(law, false)["feed_law"], json::parse(R"({"law":"off"})"));
  law.kind = lang::FeedLaw::Kind::modulated;
  law.feed_first = 30.0;
  law.feed_last = 40.0;
  law.feed_step = 1.0;
  law.path_step_mm = 0.5;
  law.steps = 10;
  EXPECT_EQ(record_of(law, false)["feed_law"],
            json::parse(R"({"law":"modulated","feed_unit":"mm/min","feed_min":30.0,"feed_max":40.0,
    "feed_step":1.0,"path_step":0.5,"steps":10})"));
  law = {};
  law.kind = lang::FeedLaw::Kind::interrupted;
  law.stand_mm = 0.5;
  law.cut_mm = 2.0;
  EXPECT_EQ(record_of(law, false)["feed_law"],
            json::parse(R"({"law":"interrupted","stand":0.5,"cut":2.0})"));
  law = {};
  law.kind = lang::FeedLaw::Kind::curve;
  law.feed_first = 60.0;  // of its first point
  law.curve = {{0.0, 60.0, 0.0}, {10.0, 80.0, 0.0}};
  EXPECT_EQ(record_of(law, false)["feed_law"], json::parse(R"({"law":"curve","feed_unit":"mm/min",
    "points":[{"path":0.0,"feed":60.0},{"path":10.0,"feed":80.0}]})"));
}

TEST(RecordFields, OfASearchHasTheModalLaw) {
  lang::SearchState state;
  state.calculated = true;
  state.feed_law.kind = lang::FeedLaw::Kind::interrupted;
  state.feed_law.stand_mm = 0.5;
  state.feed_law.cut_mm = 2.0;
  EXPECT_EQ(json(protocol::fields_json(search_fields(state, {}, {"X", "Z"})))["feed_law"],
            json::parse(R"({"law":"interrupted","stand":0.5,"cut":2.0})"));
}

}  // namespace
}  // namespace stanok::jobs

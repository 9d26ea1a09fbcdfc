// Plunge cycles as jobs: what is asked for, what is designed, its program.
#include "jobs/grinding/grind_cycle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jobs/grinding/grind_program.h"
#include "protocol/contract/fields_json.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

const std::string designed_sheet =
    stanok::testing::source_folder() + "/programs/examples/plunge_grinding.toml";
const std::string grinder_of_shop =
    stanok::testing::source_folder() + "/config/machines/grinder.toml";

GrindInput quick_input() {
  GrindRequest asked;
  asked.input = designed_sheet;
  asked.points = 2;
  auto input = grind_input(asked);
  input->request.comparison = process::Comparison::none;
  return *input;
}

TEST(GrindCycle, HasTheLawThatItsControlFileHas) {
  const GrindInput input = quick_input();
  const auto cycle = designed_cycle(input.request, {});
  ASSERT_TRUE(cycle.has_value());
  const auto json = protocol::fields_json(cycle_fields(*cycle));
  EXPECT_EQ(json.begin().key(), "ok");
  EXPECT_EQ(json.at("law").size(), cycle->design.law.size());
  EXPECT_EQ(json.at("cycle_time_s"), cycle->design.verification.run.time_s);
  EXPECT_TRUE(json.at("compare").at("three_step_s").is_null());
  const auto file = process::read_control_text(control_text(input, *cycle), "control.txt");
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->law.size(), cycle->design.law.size());
  EXPECT_NEAR(jobs::assessed_cycle(input.request, file->law).design.verification.run.time_s,
              cycle->design.verification.run.time_s, 1e-2);
}

TEST(GrindCycle, ARefusedOneTellsItsReasons) {
  GrindInput input = quick_input();
  input.request.optimiser.feedback = 1.5;
  const auto cycle = designed_cycle(input.request, {});
  ASSERT_FALSE(cycle.has_value());
  const auto json = protocol::fields_json(refusal_fields(cycle.error()));
  EXPECT_EQ(json.at("ok"), false);
  EXPECT_EQ(json.at("findings").at(0).at("code"), cycle.error().front().code);
}

TEST(GrindProgram, WarnsOfPlacesBetweenTwoIncrements) {
  GrindProgramRequest request{
      .process = quick_input().request.process,
      .law = {{.x_mm = 0.3, .feed_mm_per_s = 0.03}, {.x_mm = 0.0, .feed_mm_per_s = 0.03}},
      .machine = {.machine_file = grinder_of_shop},
      .title = "part"};
  const GrindProgram made = grind_program(request);
  EXPECT_THAT(made.text, ::testing::HasSubstr("part"));
  EXPECT_THAT(made.warnings, ::testing::IsEmpty());
  request.law.back().x_mm = 0.12345678;
  EXPECT_THAT(grind_program(request).warnings,
              ::testing::ElementsAre(::testing::HasSubstr("between two increments of axis X")));
}

}  // namespace
}  // namespace stanok::jobs

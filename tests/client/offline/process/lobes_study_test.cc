// What is made of stability lobes: best speeds, judged cuts, their report.
#include "process/chatter/lobes_study.h"

#include <gtest/gtest.h>

#include <cmath>

#include "client/offline/process/lobes_report.h"

namespace stanok::client {
namespace {

using process::LobesRequest;
using process::LobesStudy;

// One mode in turning: lobes repeat with the natural frequency.
LobesRequest one_mode() {
  LobesRequest request;
  request.process.kind = process::CutKind::turning;
  request.process.force_n_per_mm2 = 2000.0;
  request.process.modes_x = {
      {.frequency_hz = 150.0, .damping = 0.035, .stiffness_n_per_mm = 12000.0}};
  request.speed_from = 2000.0;
  request.speed_to = 12000.0;
  request.count = 400;
  return request;
}

constexpr double closed_form = 2.0 * 12000.0 * 0.035 * 1.035 / 2000.0;  // Tlusty 2000, ch. 9

TEST(LobesStudy, AlwaysStableDepthIsTheClosedForm) {
  EXPECT_NEAR(study_lobes(one_mode()).always_mm / closed_form, 1.0, 1e-3);
}

// The best speeds are near whole parts of the natural frequency: 9,000 rev/min and 4,500.
TEST(LobesStudy, BestSpeedsAreNearWholePartsOfTheNaturalFrequency) {
  const auto best = study_lobes(one_mode()).best;
  ASSERT_GE(best.size(), 2U);
  EXPECT_NEAR(best[0].speed_rev_per_min / 9000.0, 1.0, 0.1);
  EXPECT_NEAR(best[1].speed_rev_per_min / 4500.0, 1.0, 0.1);
  EXPECT_GT(best[0].depth_mm, best[1].depth_mm);
}

TEST(LobesStudy, ACutIsJudgedAndABetterSpeedProposed) {
  LobesRequest request = one_mode();
  request.programmed = {{.speed_rev_per_min = 5300.0, .depth_mm = 0.5 * closed_form},
                        {.speed_rev_per_min = 5300.0, .depth_mm = 2.0 * closed_form},
                        {.speed_rev_per_min = 5300.0, .depth_mm = 1000.0}};
  const auto cuts = study_lobes(request).cuts;
  ASSERT_EQ(cuts.size(), 3U);
  EXPECT_TRUE(cuts[0].is_stable());
  EXPECT_EQ(cuts[0].better_speed, 0.0);
  EXPECT_FALSE(cuts[1].is_stable());
  ASSERT_GT(cuts[1].better_speed, 0.0);
  const process::SemiDiscretisation motion(request.process);  // knows nothing of lobes
  EXPECT_LT(motion.growth(cuts[1].better_speed, 2.0 * closed_form), 1.0);
  EXPECT_GT(motion.growth(5300.0, 2.0 * closed_form), 1.0);
  EXPECT_FALSE(cuts[2].is_stable());
  EXPECT_EQ(cuts[2].better_speed, 0.0);
}

TEST(LobesReport, SaysWhatIsStableAndWhatIsNot) {
  LobesRequest request = one_mode();
  request.programmed = {{.speed_rev_per_min = 5300.0, .depth_mm = 1000.0}};
  const LobesStudy study = study_lobes(request);
  EXPECT_NE(to_text(study).find("chatters, limit"), std::string::npos);
  EXPECT_NE(to_text(study).find("at no speed of the range"), std::string::npos);
  EXPECT_EQ(study.limits.size(), 400U);
  EXPECT_TRUE(to_csv(study).starts_with("speed_rev_per_min,depth_mm,chatter_hz\n"));
  const std::string script = picture_script(study, "it's.png");
  EXPECT_NE(script.find("$unstable"), std::string::npos);
  EXPECT_EQ(script.find("$stable"), std::string::npos);  // an empty curve is a warning of gnuplot
  EXPECT_NE(script.find("it''s.png"), std::string::npos);
}

}  // namespace
}  // namespace stanok::client

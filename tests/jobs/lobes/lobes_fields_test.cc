#include "jobs/lobes/lobes_fields.h"

#include <gtest/gtest.h>

#include <limits>

#include "protocol/contract/fields_json.h"

namespace stanok::jobs {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

TEST(LobesFields, LeaveOutWhatIsNotKnown) {
  process::LobesStudy study;
  study.always_mm = unlimited;
  study.limits = {{.speed_rev_per_min = 1000.0, .depth_mm = 2.0, .chatter_hz = 90.0},
                  {.speed_rev_per_min = 2000.0, .depth_mm = unlimited, .chatter_hz = 0.0}};
  study.cuts = {{.speed_rev_per_min = 1000.0, .depth_mm = 3.0, .limit_mm = 2.0},
                {.speed_rev_per_min = 900.0, .depth_mm = 1.0, .limit_mm = unlimited}};
  EXPECT_EQ(protocol::fields_json(lobes_fields(study)), nlohmann::ordered_json::parse(R"({
    "always_stable_mm": null, "best": [],
    "cuts": [{"speed_rev_per_min": 1000.0, "depth_mm": 3.0, "limit_mm": 2.0, "stable": false},
             {"speed_rev_per_min": 900.0, "depth_mm": 1.0, "limit_mm": null, "stable": true}],
    "limits": [{"speed_rev_per_min": 1000.0, "depth_mm": 2.0, "chatter_hz": 90.0},
               {"speed_rev_per_min": 2000.0, "depth_mm": null}]})"));
}

}  // namespace
}  // namespace stanok::jobs

// Shared variables: one value for all channels, in the order of the text.
#include "channels/shared_variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using testing::machine_of_one_axis_channels;
using testing::MachineBench;

TEST(SharedVariables, EightChannelsCountTogether) {
  MachineBench bench(machine_of_one_axis_channels(8));
  for (int k = 1; k <= 8; ++k) {
    const std::string name = "p" + std::to_string(k) + ".nc";
    std::string text =
        "shared num part_count;\nshared num per_channel[9];\n"
        "for (num idx = 0; idx < 5; idx++) { per_channel[" +
        std::to_string(k) + "] += 1; G4 P0.001\n }\n";
    // One after the other: a read and a write are two sync points, not one.
    if (k > 1) text += "channel_wait (" + std::to_string(k - 1) + ");\n";
    text += "part_count += 1;\n";
    if (k == 8) {
      text +=
          "if (part_count != 8) { terminate (1001, str (part_count)); }\n"
          "for (num idx = 1; idx < 9; idx++) {\n"
          "if (per_channel[idx] != 5) { terminate (1002, str (per_channel[idx])); } }\n";
    }
    bench.program(name, text + "M30\n");
    bench.run(k, name);
  }
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(SharedVariables, TextsAndTruthsCrossTheMachine) {
  MachineBench bench(machine_of_one_axis_channels(2));
  bench.program("a.nc",
                "shared string part_name;\nshared bool ready[2][2];\npart_name = \"flange\";\n"
                "ready[1][0] = true;\nmark_wait (1, 2);\nM30\n");
  bench.program("b.nc",
                "shared string part_name;\nshared bool ready[2][2];\nmark_wait (1, 1);\n"
                "if (part_name + \"!\" != \"flange!\") { terminate (1001, part_name); }\n"
                "if (ready[1][0] && ready[0][1] == false) { part_name += \" done\"; }\n"
                "if (part_name != \"flange done\") { terminate (1002, part_name); }\nM30\n");
  bench.run(1, "a.nc");
  bench.run(2, "b.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(SharedVariables, AnotherTypeInAnotherProgramDoesNotLoad) {
  MachineBench bench(machine_of_one_axis_channels(2));
  bench.program("a.nc", "shared num part_count;\nM30\n");
  bench.program("b.nc", "shared bool part_count;\nM30\n");
  bench.run(1, "a.nc");
  bench.run_to_end();
  bench.run(2, "b.nc");
  bench.run_to_end();
  std::vector<std::string> codes;
  for (const auto& report : bench.machine().load_diagnostics())
    codes.push_back(report.diagnostic.code);
  EXPECT_THAT(codes, Contains("E6026"));
}

}  // namespace
}  // namespace stanok::channels

// Shared variables: one value for all channels, in the order of the text.
#include "channels/stores/shared_variables.h"

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

TEST(SharedVariables, SevenChannelsThatCountAtOnceLoseNothing) {
  MachineBench bench(machine_of_one_axis_channels(8));
  const std::string declared = "shared num ups, downs, product, halves, table[2], joined_length;\n";
  for (int k = 1; k <= 7; ++k) {
    const std::string name = "p" + std::to_string(k) + ".nc";
    bench.program(name, declared +
                            "mark_wait (1, 1, 2, 3, 4, 5, 6, 7, 8);\n"
                            "for (num idx = 0; idx < 5; idx++) {\n"
                            "ups++; downs -= 2; table[1] += 3; }\n"
                            "product *= 2; halves /= 2;\n"
                            "mark_wait (2, 1, 2, 3, 4, 5, 6, 7, 8);\nM30\n");
    bench.run(k, name);
  }
  bench.program("p8.nc", declared +
                             "product = 1; halves = 128;\n"
                             "mark_wait (1, 1, 2, 3, 4, 5, 6, 7, 8);\n"
                             "mark_wait (2, 1, 2, 3, 4, 5, 6, 7, 8);\n"
                             "if (ups != 35) { terminate (1001, str (ups)); }\n"
                             "if (downs != -70) { terminate (1002, str (downs)); }\n"
                             "if (table[1] != 105) { terminate (1003, str (table[1])); }\n"
                             "if (product != 128) { terminate (1004, str (product)); }\n"
                             "if (halves != 1) { terminate (1005, str (halves)); }\nM30\n");
  bench.run(8, "p8.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(SharedVariables, WhatCannotBeComputedIsAnAlarmAndChangesNothing) {
  const std::string long_text(200, 'a');
  const std::map<std::string, std::string> faults{
      {"num kept = 0;\ncount /= kept;", "E3008"},
      {"count *= 1e300; count *= 1e300;", "E3009"},
      {"name += \"" + long_text + "\"; name += \"" + long_text + "\";", "E3009"}};
  for (const auto& [text, code] : faults) {
    MachineBench bench(machine_of_one_axis_channels(1));
    const std::string declared = "shared num count;\nshared string name;\n";
    bench.program("a.nc", declared + "count = 5;\n" + text + "\nM30\n");
    bench.run(1, "a.nc");
    bench.run_to_end();
    EXPECT_THAT(bench.alarm_codes(), ::testing::ElementsAre(code)) << text;
    bench.ask(OperatorAction::program_reset, 1);
    bench.run_to_end();
    bench.program(
        "b.nc", declared + "if (count < 1 || len (name) > 200) { terminate (1001, \"\"); }\nM30\n");
    bench.run(1, "b.nc");
    bench.run_to_end();
    EXPECT_THAT(bench.alarm_codes(), ::testing::ElementsAre(code)) << text;
  }
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
  bench.may_refuse();
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

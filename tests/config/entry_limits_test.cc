// [entry_limits]: what a machine file says, leaves out and must not say; and that the tables of the
// machines of the project are plausible.
#include <gtest/gtest.h>

#include "channels/contract/entry_bounds.h"
#include "config/files/machine_file.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

using channels::EntryBound;
using channels::EntryBounds;
using channels::EntryLimits;
using channels::MachineConfig;
using channels::ToolValue;

std::filesystem::path machines_folder() {
  return std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines";
}

EntryLimits limits_of(const std::string& machine, const std::string& section) {
  const TemporaryFiles files;
  const std::string text =
      "[machine]\nname = \"m\"\n"
      "[[axis]]\nname = \"X\"\nkind = \"linear\"\nmin = -10\nmax = 10\nvelocity_max = 100\n"
      "acceleration_max = 1e3\njerk_max = 2e4\n"
      "[[channel]]\nid = 1\nname = \"work\"\nkind = \"" +
      machine + "\"\naxes = [\"X\"]\n" + section;
  return read_machine_file(files.write("m.toml", text)).machine.entry_limits;
}

TEST(EntryLimits, HaveDefaultsThatFindSlips) {
  const EntryLimits limits = limits_of("mill", "");
  EXPECT_EQ(limits.touch_off_max, 100.0);
  EXPECT_EQ(limits.change_max, 100.0);
  EXPECT_EQ(limits.change_in_run_max, 0.5);
  EXPECT_EQ(limits.tool_length_min_mm, 0.0);
  EXPECT_EQ(limits.tool_length_max_mm, 500.0);
  EXPECT_EQ(limits.tool_radius_max_mm, 250.0);
  EXPECT_EQ(limits.wear_max_mm, 2.0);
  EXPECT_EQ(limits.offset_max_mm, 0.0) << "by the travel";
}

TEST(EntryLimits, OfALathePermitLengthsOfEitherSignUnlessItSaysOtherwise) {
  EXPECT_EQ(limits_of("lathe", "").tool_length_min_mm, -500.0);
  EXPECT_EQ(limits_of("lathe", "[entry_limits]\ntool_length_max = 300\n").tool_length_min_mm,
            -300.0);
  EXPECT_EQ(limits_of("lathe", "[entry_limits]\ntool_length_min = 5\n").tool_length_min_mm, 5.0);
}

TEST(EntryLimits, AreThoseOfTheFile) {
  const EntryLimits limits =
      limits_of("mill",
                "[entry_limits]\ntouch_off_max = 1\nchange_max = 2\ntool_length_min = -3\n"
                "tool_length_max = 4\ntool_radius_max = 5\nwear_max = 6\noffset_max = 7\n"
                "change_in_run_max = 8\n");
  EXPECT_EQ(limits.touch_off_max, 1.0);
  EXPECT_EQ(limits.change_max, 2.0);
  EXPECT_EQ(limits.tool_length_min_mm, -3.0);
  EXPECT_EQ(limits.tool_length_max_mm, 4.0);
  EXPECT_EQ(limits.tool_radius_max_mm, 5.0);
  EXPECT_EQ(limits.wear_max_mm, 6.0);
  EXPECT_EQ(limits.offset_max_mm, 7.0);
  EXPECT_EQ(limits.change_in_run_max, 8.0);
}

void expect_plausible(const MachineConfig& machine) {
  const EntryBounds bounds(machine);
  const auto tool_value = [&](const channels::ToolEdge& tool, ToolValue value, double is) {
    const EntryBound bound = bounds.of_tool(value);
    EXPECT_TRUE(bound.holds(is)) << tool.number << ": " << reason_against(bound, is).view();
  };
  for (const channels::ToolEdge& tool : machine.tables.tools) {
    tool_value(tool, ToolValue::length, tool.length);
    tool_value(tool, ToolValue::length_x, tool.length_x);
    tool_value(tool, ToolValue::length_y, tool.length_y);
    tool_value(tool, ToolValue::radius, tool.radius);
    tool_value(tool, ToolValue::overhang, tool.overhang);
    tool_value(tool, ToolValue::wear_length, tool.wear_length);
    tool_value(tool, ToolValue::wear_length_x, tool.wear_length_x);
    tool_value(tool, ToolValue::wear_radius, tool.wear_radius);
  }
  for (const auto& [name, row] : machine.tables.offsets) {
    for (const auto& [axis, is] : row) {
      const auto found = std::ranges::find(machine.axes, axis, &channels::AxisConfig::name);
      const EntryBound bound = bounds.of_offset(static_cast<int>(found - machine.axes.begin()));
      EXPECT_TRUE(bound.holds(is)) << name << ": " << reason_against(bound, is).view();
    }
  }
}

TEST(EntryLimits, HoldTheTablesOfTheMachinesOfTheProject) {
  int tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(machines_folder())) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    const MachineConfig machine = read_machine_file(entry.path()).machine;
    tables += machine.tables.tools.empty() ? 0 : 1;
    expect_plausible(machine);
  }
  EXPECT_GE(tables, 6);
}

}  // namespace
}  // namespace stanok::config

// Files of `stanok process lobes`: what they fill, and what is refused.
#include "config/files/chatter_file.h"

#include <gtest/gtest.h>

#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

constexpr const char* turning = R"(kind = "turning"
force = 2000.0
[[mode_x]]
frequency = 150.0
damping = 0.035
stiffness = 12.0
)";

std::vector<ConfigFault> faults_of_cut(const std::string& text) {
  const TemporaryFiles files;
  try {
    static_cast<void>(read_chatter_file(files.write("cut.toml", text)));
  } catch (const ConfigError& error) {
    return error.faults();
  }
  return {};
}

TEST(ChatterFile, FillsACut) {
  const TemporaryFiles files;
  const auto cut = read_chatter_file(files.write("cut.toml", turning));
  EXPECT_EQ(cut.kind, process::CutKind::turning);
  EXPECT_EQ(cut.force_n_per_mm2, 2000.0);
  ASSERT_EQ(cut.modes_x.size(), 1U);
  EXPECT_EQ(cut.modes_x[0].stiffness_n_per_mm, 12000.0);  // 12 N/um
  EXPECT_TRUE(cut.modes_y.empty());
}

TEST(ChatterFile, TheExampleIsASlot) {
  const auto cut =
      read_chatter_file(stanok::testing::source_folder() + "/programs/examples/slot_lobes.toml");
  EXPECT_EQ(cut.kind, process::CutKind::milling);
  EXPECT_EQ(cut.teeth, 3);
  EXPECT_NEAR(cut.entry_rad, 0.0, 1e-12);
  EXPECT_NEAR(cut.exit_rad, std::numbers::pi, 1e-12);
  EXPECT_EQ(cut.modes_y[0].frequency_hz, 670.0);
}

TEST(ChatterFile, FaultsHaveTheirPlace) {
  const std::string text(turning);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string copy = text;
    return copy.replace(copy.find(from), from.size(), to);
  };
  const auto expect_fault = [](const std::string& file, std::size_t line, const char* words) {
    const auto faults = faults_of_cut(file);
    ASSERT_FALSE(faults.empty()) << words;
    EXPECT_EQ(faults.front().line, line) << faults.front().text;
    EXPECT_NE(faults.front().text.find(words), std::string::npos) << faults.front().text;
  };
  expect_fault(changed("0.035", "3.5"), 5, "damping is 3.5");
  expect_fault(changed("force", "forse"), 1, "'force' is missing");
  expect_fault(changed("\"turning\"", "\"boring\""), 1, "boring");
  expect_fault(changed("[[mode_x]]", "[[mode_y]]"), 3, "[[mode_x]]");
  expect_fault(text.substr(0, text.find("[[mode_x]]")), 1, "at least one");
  std::string many = text;
  for (int k = 0; k < 8; ++k) many += text.substr(text.find("[[mode_x]]"));
  expect_fault(many, 1, "9 modes");
}

}  // namespace
}  // namespace stanok::config

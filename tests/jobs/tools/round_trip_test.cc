// What a format carries comes back from it: over seeds, for every row of tool_formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "config/text/config_error.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/tool_conversion.h"
#include "jobs/tools/tool_formats.h"
#include "jobs/tools/tool_values.h"
#include "tests/support/sanitized.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

bool is_of_kind(const CarriedKey& key, const std::string& kind) {
  std::istringstream kinds{std::string(key.kinds)};
  std::string one;
  if (key.kinds.empty()) return true;
  while (kinds >> one)
    if (one == kind) return true;
  return false;
}

// Random tools that the format carries whole, with lengths on the grid of its file.
class RandomTools {
 public:
  RandomTools(const ToolFormat& format, LengthUnit unit, unsigned seed)
      : format_(format), unit_(unit), random_(seed) {}

  std::vector<ToolEdge> tools() {
    std::set<std::pair<int, int>> numbers;
    const std::size_t count = 1 + random_() % 20;
    while (numbers.size() < count) {
      const int edge =
          format_.numbers == ToolNumbers::number ? 1 : static_cast<int>(1 + random_() % 9);
      numbers.emplace(static_cast<int>(1 + random_() % 400), edge);
    }
    std::vector<ToolEdge> tools;
    for (const auto& [number, edge] : numbers) tools.push_back(tool(number, edge));
    return tools;
  }

 private:
  double on_grid() {
    const int decimals = format_.decimals.mm == 0  ? 5
                         : unit_ == LengthUnit::mm ? format_.decimals.mm
                                                   : format_.decimals.inch;
    return mm_of(static_cast<double>(random_() % 4'000'000) / std::pow(10.0, decimals), unit_);
  }
  std::string text() {
    static const std::vector<std::string> words{"end mill", "6.35",     "1/4", "long",
                                                "R0.5",     "\"fine\"", "a,b", "x;y"};
    std::string name = "T";
    for (unsigned i = 0; i < random_() % 4; ++i) name += " " + words[random_() % words.size()];
    return name;
  }
  double value(const ToolKey& key) {
    if (key.name == "orientation") return static_cast<double>(1 + random_() % 9);
    if (is_length(key)) {
      const bool is_signed = std::isinf(key.allowed.min);
      return is_signed && random_() % 4 == 0 ? -on_grid() : on_grid();
    }
    const double max = std::min(key.allowed.max, 170.0);
    return static_cast<double>(random_() % static_cast<unsigned>(max * 10.0)) / 10.0;
  }
  ToolEdge tool(int number, int edge) {
    ToolEdge tool;
    tool.number = number;
    tool.edge = edge;
    if (!format_.kinds.empty()) tool.kind = format_.kinds[random_() % format_.kinds.size()];
    for (const CarriedKey& carried : format_.carried) {
      const ToolKey& key = tool_key(carried.key);
      if (!is_of_kind(carried, tool.kind) || random_() % 3 == 0) continue;
      if (is_text(key)) {
        set_text(tool, key, text());
      } else {
        EXPECT_TRUE(set_number(tool, key, value(key)));
      }
    }
    tool.corner_radius = std::min(tool.corner_radius, tool.radius);
    if (tool.kind == "ball" && tool.corner_radius != 0.0) tool.corner_radius = tool.radius;
    if (format_.kinds.empty() && tool.orientation != 0) tool.kind = "insert";
    return tool;
  }

  const ToolFormat& format_;
  LengthUnit unit_;
  std::mt19937 random_;
};

void expect_back(const ToolFormat& format, const std::vector<ToolEdge>& tools, LengthUnit unit,
                 CutterSize cutter) {
  const std::string suffix(format.suffixes.empty() ? ".txt" : format.suffixes.front());
  const ExportedTools exported =
      export_tools({.tools = tools,
                    .format = &format,
                    .choice = {.file = "library" + suffix, .unit = unit, .cutter = cutter}});
  for (const NotCarried& lost : exported.not_carried) {
    ADD_FAILURE() << "tool " << lost.tool << " " << lost.field << " " << lost.value << ": "
                  << lost.reason;
  }
  const auto other = [&](const std::filesystem::path& file) -> std::optional<std::string> {
    for (const ForeignFile& one : exported.files)
      if (one.file.filename() == file.filename()) return one.bytes;
    return std::nullopt;
  };
  const ForeignTools back = format.read({.file = exported.files.back().file,
                                         .bytes = exported.files.back().bytes,
                                         .unit = unit,
                                         .cutter = cutter,
                                         .other_file = other});
  EXPECT_TRUE(back.not_carried.empty()) << back.not_carried.front().field;
  ASSERT_EQ(back.tools.size(), tools.size());
  for (std::size_t i = 0; i < tools.size(); ++i) {
    for (const ToolKey& key : config::tool_keys()) {
      if (key.name == "kind" && format.kinds.empty()) continue;
      EXPECT_EQ(text_of(back.tools[i].edge, key), text_of(tools[i], key))
          << "tool " << tools[i].number << ": " << key.name;
    }
  }
}

TEST(ToolLibraries, GiveBackWhatTheirFormatCarries) {
  for (const ToolFormat& format : tool_formats()) {
    if (format.write == nullptr) continue;
    for (unsigned seed = 1; seed <= testing::cases(200U); ++seed) {
      const LengthUnit unit = seed % 2 == 0 ? LengthUnit::mm : LengthUnit::inch;
      const CutterSize cutter = seed % 3 == 0 ? CutterSize::radius : CutterSize::diameter;
      SCOPED_TRACE(::testing::Message() << format.name << ", seed " << seed);
      expect_back(format, RandomTools(format, unit, seed).tools(), unit, cutter);
      if (HasFailure()) return;
    }
  }
}

// A list that names what does not come back would promise too much; what comes back and is not on
// it would be missing in the documentation.
TEST(ToolLibraries, CarryTheKeysOfTheirRowAndNoOthers) {
  for (const ToolFormat& format : tool_formats()) {
    if (format.write == nullptr) continue;
    for (const ToolKey& key : config::tool_keys()) {
      if (key.name == "number" || key.name == "edge" || key.name == "kind") continue;
      ToolEdge tool;
      tool.number = 5;
      tool.radius = key.name == "corner_radius" ? 4.0 : 0.0;
      if (is_text(key)) {
        set_text(tool, key, "name");
      } else {
        EXPECT_TRUE(set_number(tool, key, 3.0));
      }
      const bool is_listed = std::ranges::any_of(format.carried, [&](const CarriedKey& carried) {
        return carried.key == key.name && is_of_kind(carried, tool.kind);
      });
      const std::vector<ToolEdge> tools{tool};
      const ExportedTools exported = export_tools(
          {.tools = tools, .format = &format, .choice = {.file = "library", .cutter = {}}});
      const bool is_lost = std::ranges::any_of(
          exported.not_carried, [&](const NotCarried& lost) { return lost.field == key.name; });
      EXPECT_NE(is_listed, is_lost) << format.name << ": " << key.name;
    }
  }
}

TEST(ToolLibraries, SayThatTheyHaveOneEdgeForEachTool) {
  std::vector<ToolEdge> tools(2);
  tools[0].number = tools[1].number = 7;
  tools[0].edge = 2;
  for (const ToolFormat& format : tool_formats()) {
    if (format.write == nullptr || format.numbers != ToolNumbers::number) continue;
    const ExportedTools exported = export_tools(
        {.tools = tools, .format = &format, .choice = {.file = "library", .cutter = {}}});
    ASSERT_EQ(exported.not_carried.size(), 1U) << format.name;
    EXPECT_EQ(exported.not_carried[0].edge, 2);
    EXPECT_EQ(exported.not_carried[0].field, "tool");
  }
}

TEST(ToolLibraries, AreRefusedWithoutTools) {
  for (const ToolFormat& format : tool_formats()) {
    if (format.write == nullptr) continue;
    EXPECT_THROW(
        static_cast<void>(export_tools(
            {.tools = {}, .format = &format, .choice = {.file = "library", .cutter = {}}})),
        config::ConfigError);
  }
}

}  // namespace
}  // namespace stanok::jobs

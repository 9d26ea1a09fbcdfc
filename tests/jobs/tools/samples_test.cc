// Sample files in the style of the programs that write them, and what becomes of them when they are
// damaged: values, or faults, never anything else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "config/text/config_error.h"
#include "jobs/tools/tables_text.h"
#include "jobs/tools/tool_conversion.h"
#include "jobs/tools/tool_values.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"

namespace stanok::jobs {
namespace {

namespace fs = std::filesystem;

const std::string samples_folder = testing::source_folder() + "/tests/jobs/tools/samples/";

struct Sample {
  const ToolFormat* format;
  fs::path file;
};

// Files that only others name are not samples of their own.
std::vector<Sample> samples() {
  std::vector<Sample> found;
  for (const ToolFormat& format : tool_formats()) {
    for (const auto& entry : fs::directory_iterator(samples_folder + std::string(format.name))) {
      if (entry.is_regular_file()) found.push_back({&format, entry.path()});
    }
  }
  return found;
}

std::optional<std::string> bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

ForeignTools read(const Sample& sample, const std::string& bytes) {
  return sample.format->read({.file = sample.file,
                              .bytes = bytes,
                              .unit = std::nullopt,
                              .cutter = std::nullopt,
                              .other_file = &bytes_of});
}

TEST(SampleLibraries, AreFivePerFormat) {
  std::map<std::string, int> count;
  for (const Sample& sample : samples()) ++count[std::string(sample.format->name)];
  for (const ToolFormat& format : tool_formats()) {
    EXPECT_GE(count[std::string(format.name)], 5) << format.name;
  }
}

TEST(SampleLibraries, AreReadAndHaveRadii) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.file);
    const ForeignTools found = read(sample, bytes_of(sample.file).value());
    EXPECT_FALSE(found.tools.empty());
    for (const ForeignTool& tool : found.tools) {
      EXPECT_GE(tool.edge.number, 1);
      EXPECT_LT(tool.edge.radius, 200.0);
    }
  }
}

// What was read is written in the same format, in the unit of the sample, and read again.
TEST(SampleLibraries, ComeBackFromTheirOwnFormat) {
  for (const Sample& sample : samples()) {
    if (sample.format->write == nullptr) continue;
    SCOPED_TRACE(sample.file);
    const ForeignTools found = read(sample, bytes_of(sample.file).value());
    std::vector<channels::ToolEdge> tools;
    for (const ForeignTool& tool : found.tools) tools.push_back(tool.edge);
    const auto lost_in = [&](LengthUnit unit) {
      const WriteChoice choice{.file = "library", .unit = unit, .cutter = {}};
      return export_tools({.tools = tools, .format = sample.format, .choice = choice}).not_carried;
    };
    const auto lost = lost_in(LengthUnit::mm);
    if (lost.empty()) continue;
    EXPECT_TRUE(lost_in(LengthUnit::inch).empty())
        << "tool " << lost[0].tool << " " << lost[0].field << " " << lost[0].value << ": "
        << lost[0].reason;
  }
}

std::string damaged(std::string bytes, std::mt19937& random) {
  static const std::vector<std::string> pieces{
      "nan",      "inf",  "1e999", "-1",  "99999999999999999999",
      "\xFF\xFE", "\xC3", "\"",    "{",   "[[[[[[[[[[",
      "\n",       "T1 P", ",",     "0x1", "\0",
      "null",     "1",    ";",     "}",   "%"};
  for (unsigned i = 0; i <= random() % 3 && !bytes.empty(); ++i) {
    const std::size_t at = random() % bytes.size();
    const std::size_t length = 1 + random() % 20;
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, pieces[random() % pieces.size()]);
        break;
      case 3:
        bytes.insert(at, bytes.substr(bytes.size() - std::min(bytes.size(), length * 10)));
        break;
      default:
        bytes.resize(at);
    }
  }
  return bytes;
}

TEST(SampleLibraries, ThatAreDamagedAreRefusedOrGiveToolsThatLoad) {
  const unsigned cases = testing::cases(400U);
  for (const Sample& sample : samples()) {
    const std::string whole = bytes_of(sample.file).value();
    for (unsigned seed = 1; seed <= cases; ++seed) {
      SCOPED_TRACE(::testing::Message() << sample.file << ", seed " << seed);
      std::mt19937 random(seed);
      try {
        const ForeignTools found = read(sample, damaged(whole, random));
        const auto tools = config::read_tools_text(tables_text(found.tools), "tables.toml");
        ASSERT_EQ(tools.size(), found.tools.size());
        for (std::size_t i = 0; i < tools.size(); ++i) {
          EXPECT_EQ(text_of(tools[i], tool_key("length")),
                    text_of(found.tools[i].edge, tool_key("length")));
        }
      } catch (const config::ConfigError& error) {
        ASSERT_FALSE(error.faults().empty());
        for (const config::ConfigFault& fault : error.faults()) {
          EXPECT_FALSE(fault.text.empty());
          EXPECT_LT(fault.text.size(), 500U) << fault.text;
        }
      }
    }
  }
}

TEST(SampleLibraries, AreNotAccidentallyOfAnotherFormat) {
  for (const Sample& sample : samples()) {
    for (const ToolFormat& format : tool_formats()) {
      SCOPED_TRACE(::testing::Message() << sample.file << " as " << format.name);
      if (&format == sample.format) continue;
      try {
        static_cast<void>(read({&format, sample.file}, bytes_of(sample.file).value()));
      } catch (const config::ConfigError& error) {
        EXPECT_FALSE(error.faults().empty());
      }
    }
  }
}

}  // namespace
}  // namespace stanok::jobs

// Process files of plunge grinding: what they fill, and one row for every key and kind of mistake.
#include "config/files/grinding_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view example = R"(part_radius = 30.0
width = 20.0
wheel_radius = 200.0
stiffness = 25_000_000.0
mass = 32.0
damping = 50911.7
part_speed = 120.0
force_factor = 3.6
force_exponent = 0.56
deflection_max = 0.010
critical_allowance = 0.090
removal_end = 0.050
allowance = 0.3
)";

// The example with the line of a key replaced, or, when it has none, with the line added.
std::string example_with(const std::string& key, const std::string& line) {
  std::string text(example);
  const std::size_t begin = text.starts_with(key + " =") ? 0 : text.find("\n" + key + " =");
  if (begin == std::string::npos) return text + line + "\n";
  const std::size_t place = begin == 0 ? 0 : begin + 1;
  return text.replace(place, text.find('\n', place) - place, line);
}

std::vector<ConfigFault> faults_of_process(const std::string& text) {
  const TemporaryFiles files;
  try {
    static_cast<void>(read_grinding_file(files.write("p.toml", text)));
  } catch (const ConfigError& error) {
    return error.faults();
  }
  return {};
}

TEST(GrindingFile, FillsTheRequestOfADesign) {
  const TemporaryFiles files;
  const auto request = read_grinding_file(files.write(
      "p.toml", std::string(example) + "removal_form = \"exact\"\nfeed_max = 0.05\nspark_out = 3\n"
                                       "wear_factor = 1e-4\nwear_exponent = 2\nburn_margin = 0\n"));
  EXPECT_EQ(request.process.part_radius_mm, 30.0);
  EXPECT_EQ(request.process.stiffness_n_per_m, 25e6);
  EXPECT_EQ(request.process.removal, process::RemovalForm::exact);
  EXPECT_EQ(request.allowance_mm, 0.3);
  EXPECT_EQ(request.feeds.max_mm_per_s, 0.05);
  EXPECT_EQ(request.simulation.spark_out_revolutions, 3.0);
  EXPECT_EQ(request.limits.burn_margin, 0.0);
  ASSERT_TRUE(request.simulation.wear_rate_mm_per_s);
  EXPECT_NEAR(request.simulation.wear_rate_mm_per_s(0.3), 1e-4 * 0.09, 1e-18);
}

TEST(GrindingFile, OfTheProjectIsReadWithoutFault) {
  const auto request = read_grinding_file(stanok::testing::source_folder() +
                                          "/programs/examples/plunge_grinding.toml");
  EXPECT_TRUE(process::request_findings(request).empty());
  EXPECT_FALSE(request.simulation.wear_rate_mm_per_s);
}

struct Mistake {
  const char* name;
  std::string key;
  std::string line;  // "": the key is missing
  unsigned at_line;
  std::vector<std::string> named;
};

class GrindingMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(GrindingMistake, IsNamedWithKeyValueAndRange) {
  const Mistake& mistake = GetParam();
  const auto faults = faults_of_process(example_with(mistake.key, mistake.line));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().line, mistake.at_line) << faults.front().text;
  EXPECT_GE(faults.front().column, 1U);
  EXPECT_THAT(faults.front().text, HasSubstr(mistake.key));
  for (const std::string& word : mistake.named) EXPECT_THAT(faults.front().text, HasSubstr(word));
}

constexpr std::array keys{"part_radius",    "width",          "wheel_radius",       "stiffness",
                          "mass",           "damping",        "part_speed",         "force_factor",
                          "force_exponent", "deflection_max", "critical_allowance", "removal_end",
                          "allowance"};

// Each required key: missing, negative, zero, not a number, infinite, a text.
std::vector<Mistake> mistakes_of_every_key() {
  static std::vector<std::string> names;
  names.reserve(keys.size() * 6);
  std::vector<Mistake> mistakes;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::string key = keys[k];
    const auto line = static_cast<unsigned>(k + 1);
    const auto add = [&](const char* kind, const std::string& text, unsigned at,
                         std::vector<std::string> named) {
      names.push_back(key + "_" + kind);
      mistakes.push_back({names.back().c_str(), key, text, at, std::move(named)});
    };
    add("missing", "", 1, {"missing"});
    add("negative", key + " = -1.5", line, {"is -1.5", "it must be"});
    add("zero", key + " = 0.0", line, {"is 0", "it must be"});
    add("nan", key + " = nan", line, {"not finite"});
    add("infinite", key + " = inf", line, {"not finite"});
    add("text", key + " = \"1.5\"", line, {"is a text"});
  }
  return mistakes;
}

std::vector<Mistake> other_mistakes() {
  return {
      {"StiffnessInNewtonPerMillimetre",
       "stiffness",
       "stiffness = 25000.0",
       4,
       {"25000 N/mm would be 25000000 N/m"}},
      {"DampingInSecondsPerMillimetre", "damping", "damping = 0.05", 6, {"0.05 N s/mm"}},
      {"DeflectionInMicrometres",
       "deflection_max",
       "deflection_max = 10",
       10,
       {"10 um would be 0.01 mm"}},
      {"CriticalAllowanceInMicrometres",
       "critical_allowance",
       "critical_allowance = 90",
       11,
       {"90 um would be 0.09 mm"}},
      {"RadiusInMetres", "part_radius", "part_radius = 0.03", 1, {"0.03 m would be 30 mm"}},
      {"SpeedInTurnsPerSecond", "part_speed", "part_speed = 0.5", 7, {"0.5 rev/s would be 30"}},
      {"AllowanceInMicrometres", "allowance", "allowance = 300", 13, {"is 300", "10"}},
      {"CriticalAboveTheAllowance",
       "critical_allowance",
       "critical_allowance = 0.4",
       11,
       {"is 0.4", "at most the allowance, 0.3 mm"}},
      {"EndAboveTheGreatestRemoval", "removal_end", "removal_end = 0.5", 12, {"is 0.5", "0.4082"}},
      {"ExponentAboveOne", "force_exponent", "force_exponent = 1.2", 9, {"0.1 to 1"}},
      {"FeedMinAboveFeedMax",
       "feed_min",
       "feed_min = 0.05\nfeed_max = 0.04",
       14,
       {"below feed_max, 0.04"}},
      {"FeedZero", "feed_max", "feed_max = 0.0", 14, {"is 0"}},
      {"FeedInMillimetresPerMinute", "feed_max", "feed_max = 2.4", 14, {"is 2.4", "mm/s"}},
      {"TimeStepTooLong", "time_step", "time_step = 0.001", 14, {"5e-04"}},
      {"UnknownForm", "removal_form", "removal_form = \"square\"", 14, {"triangle"}},
      {"UnknownKey", "stifness", "stifness = 1", 14, {"did you mean 'stiffness'"}},
  };
}

const auto name_of_parameter = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(EveryKey, GrindingMistake, ::testing::ValuesIn(mistakes_of_every_key()),
                         name_of_parameter);
INSTANTIATE_TEST_SUITE_P(Others, GrindingMistake, ::testing::ValuesIn(other_mistakes()),
                         name_of_parameter);

TEST(GrindingFaults, AreAllShownAtOnce) {
  std::string text = example_with("mass", "mass = -1");
  text.replace(text.find("0.56"), 4, "0.00");
  EXPECT_EQ(faults_of_process(text).size(), 2U);
}

}  // namespace
}  // namespace stanok::config

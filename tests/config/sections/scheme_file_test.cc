// Schemes of every type in a machine file: each key goes to its place, each kind of mistake in each
// key is refused at its line and column, in words that say why.
//
// A case is a whole machine of five axes with one scheme, one key a line, so that the place of a
// fault follows from the position of the key.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/files/machine_file.h"
#include "config/sections/scheme_keys.h"
#include "tests/config/machine_faults.h"
#include "tests/config/temporary_files.h"

namespace stanok::config {
namespace {

using kinematics::SchemeConfig;
using ::testing::HasSubstr;

struct KeyLine {
  std::string key;
  std::string value;
};
using SchemeLines = std::vector<KeyLine>;  // after type and axes

// One valid scheme of every type, with every key of the type.
const std::vector<std::pair<std::string, SchemeLines>>& valid_schemes() {
  static const std::vector<std::pair<std::string, SchemeLines>> schemes = {
      {"cartesian", {}},
      {"lathe", {{"x_reading", "\"diameter\""}, {"turret", "\"front\""}}},
      {"head_table",
       {{"head_axis", "\"B\""},
        {"head_vector", "[2, 0, 0]"},
        {"table_axis", "\"C\""},
        {"table_vector", "[0, 3, 4]"},
        {"pivot_to_spindle", "[1, 2, -200]"},
        {"table_centre", "[10, 20, -350]"}}},
      {"head_head",
       {{"outer_axis", "\"C\""},
        {"outer_vector", "[0, 0, 2]"},
        {"inner_axis", "\"B\""},
        {"inner_vector", "[3, 4, 0]"},
        {"pivot_to_pivot", "[3, -45, -120]"},
        {"pivot_to_spindle", "[0.5, 12, -180]"}}},
      {"table_table",
       {{"outer_axis", "\"B\""},
        {"outer_vector", "[-0.5, 0, 0]"},
        {"inner_axis", "\"C\""},
        {"inner_vector", "[0, 0, 1]"},
        {"table_centre", "[-15, 30, -420]"},
        {"centre_to_centre", "[1, -25, 55]"}}},
  };
  return schemes;
}

const SchemeLines& valid_scheme(std::string_view type) {
  return std::ranges::find(valid_schemes(), type, &std::pair<std::string, SchemeLines>::first)
      ->second;
}

const std::string& machine_text() {
  static const std::string text = [] {
    std::string lines = "[machine]\nname = \"m\"\n";
    for (const std::string name : {"X", "Y", "Z", "B", "C"}) {
      const bool rotary = name == "B" || name == "C";
      lines += "[[axis]]\nname = \"" + name + "\"\nkind = \"" + (rotary ? "rotary" : "linear") +
               "\"\n" + (rotary ? "" : "min = -500\nmax = 500\n") +
               "velocity_max = 100\nacceleration_max = 1000\njerk_max = 10000\n";
    }
    return lines +
           "[[channel]]\nid = 1\nname = \"work\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n";
  }();
  return text;
}

// Lines of the scheme in the file, counted from 1.
unsigned scheme_line() {
  return static_cast<unsigned>(std::ranges::count(machine_text(), '\n')) + 1;
}
constexpr unsigned keys_after_scheme_line = 4;  // [[channel.scheme]], id, type, axes

std::string file_text(const std::string& type, const SchemeLines& lines,
                      const std::string& axes = R"(["X", "Y", "Z", "B", "C"])") {
  std::string text =
      machine_text() + "[[channel.scheme]]\nid = 1\ntype = \"" + type + "\"\naxes = " + axes + "\n";
  for (const KeyLine& line : lines) text += line.key + " = " + line.value + "\n";
  return text;
}

SchemeConfig read_scheme(const std::string& type) {
  const TemporaryFiles files;
  const auto path = files.write("m.toml", file_text(type, valid_scheme(type)));
  return read_machine_file(path).machine.channels[0].schemes[0];
}

std::vector<ConfigFault> faults_of_text(const std::string& text) {
  const TemporaryFiles files;
  return faults_of_machine(files.write("m.toml", text));
}

void expect_one_fault(const std::string& text, unsigned line, unsigned column,
                      const std::string& words) {
  const std::vector<ConfigFault> faults = faults_of_text(text);
  ASSERT_FALSE(faults.empty()) << text;
  EXPECT_EQ(faults[0].line, line) << faults[0].text;
  EXPECT_EQ(faults[0].column, column) << faults[0].text;
  EXPECT_THAT(faults[0].text, HasSubstr("channel 1: scheme 1: " + words));
  EXPECT_EQ(faults.size(), 1U) << "also: " << to_string(faults.back());
}

TEST(SchemeFile, EveryTypeAFileMayNameHasAValidExample) {
  for (const kinematics::TypeOfScheme& type : kinematics::scheme_types()) {
    if (type.chosen_by != kinematics::ChosenBy::file) continue;
    const bool is_here = std::ranges::count(valid_schemes(), type.name,
                                            &std::pair<std::string, SchemeLines>::first) == 1;
    EXPECT_TRUE(is_here) << type.name;
  }
  for (const auto& [type, lines] : valid_schemes()) {
    EXPECT_THAT(faults_of_text(file_text(type, lines)), ::testing::IsEmpty()) << type;
  }
}

TEST(SchemeFile, LatheKnowsItsReadingAndItsTurret) {
  const SchemeConfig scheme = read_scheme("lathe");
  const auto& lathe = std::get<kinematics::Lathe::Geometry>(scheme.geometry);
  EXPECT_EQ(lathe.x_reading, kinematics::XReading::diameter);
  EXPECT_EQ(lathe.turret, kinematics::Turret::front);
  EXPECT_EQ(scheme.zero, kinematics::AxisVector<double>{});
}

TEST(SchemeFile, VectorsOfRotaryAxesAreShortenedToOne) {
  const SchemeConfig scheme = read_scheme("head_table");
  const auto& geometry = std::get<kinematics::HeadTable::Geometry>(scheme.geometry);
  EXPECT_EQ(geometry.head_axis, 3);
  EXPECT_EQ(geometry.head_vector, (Vector3<double>{1, 0, 0}));
  EXPECT_EQ(geometry.table_axis, 4);
  EXPECT_EQ(geometry.table_vector, (Vector3<double>{0, 0.6, 0.8}));
}

TEST(SchemeFile, HeadHeadHasItsAxesAndItsZeroWhereTheNoseReadsZero) {
  const SchemeConfig scheme = read_scheme("head_head");
  const auto& geometry = std::get<kinematics::HeadHead::Geometry>(scheme.geometry);
  EXPECT_EQ(geometry.outer_axis, 4);
  EXPECT_EQ(geometry.outer_vector, (Vector3<double>{0, 0, 1}));
  EXPECT_EQ(geometry.inner_axis, 3);
  EXPECT_EQ(geometry.inner_vector, (Vector3<double>{0.6, 0.8, 0}));
  EXPECT_EQ(geometry.pivot_to_pivot, (Vector3<double>{3, -45, -120}));
  EXPECT_EQ(geometry.pivot_to_spindle, (Vector3<double>{0.5, 12, -180}));
  EXPECT_EQ(scheme.zero, kinematics::AxisVector<double>{});
}

TEST(SchemeFile, TableTableHasItsZeroOnTheInnerCentre) {
  const SchemeConfig scheme = read_scheme("table_table");
  const auto& geometry = std::get<kinematics::TableTable::Geometry>(scheme.geometry);
  EXPECT_EQ(geometry.outer_axis, 3);
  EXPECT_EQ(geometry.outer_vector, (Vector3<double>{-1, 0, 0}));
  EXPECT_EQ(geometry.inner_axis, 4);
  EXPECT_EQ(geometry.table_centre, (Vector3<double>{-15, 30, -420}));
  EXPECT_EQ(geometry.centre_to_centre, (Vector3<double>{1, -25, 55}));
  EXPECT_EQ(scheme.zero, (kinematics::AxisVector<double>{-14, 5, -365}));
}

TEST(SchemeFaults, EveryKeyOfEveryTypeRefusesAnotherKindOfValue) {
  for (const auto& [type, lines] : valid_schemes()) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      SchemeLines wrong = lines;
      wrong[i].value = "true";
      const auto column = static_cast<unsigned>(lines[i].key.size()) + 4;
      expect_one_fault(file_text(type, wrong),
                       scheme_line() + keys_after_scheme_line + static_cast<unsigned>(i), column,
                       lines[i].key + " is true or false; write ");
    }
  }
}

TEST(SchemeFaults, EveryTypeMissesItsRequiredKeysAndNoOthers) {
  for (const auto& [type, lines] : valid_schemes()) {
    kinematics::SchemeGeometry geometry = kinematics::find_scheme_type(type)->geometry;
    const auto keys = kinematics::keys_of(geometry);
    for (const KeyLine& line : lines) {
      SchemeLines wrong = lines;
      std::erase_if(wrong, [&](const KeyLine& each) { return each.key == line.key; });
      const auto key = std::ranges::find(keys, line.key, &kinematics::SchemeKey::name);
      const bool is_required = key->presence == kinematics::KeyPresence::required;
      if (!is_required) {
        EXPECT_THAT(faults_of_text(file_text(type, wrong)), ::testing::IsEmpty()) << line.key;
        continue;
      }
      expect_one_fault(file_text(type, wrong), scheme_line(), 1,
                       "key '" + line.key + "' is missing; a " + type + " scheme needs it");
    }
  }
}

TEST(SchemeFaults, EveryTypeRefusesTheKeysOfOthers) {
  for (const auto& [type, lines] : valid_schemes()) {
    for (const auto& [other, other_lines] : valid_schemes()) {
      for (const KeyLine& foreign : other_lines) {
        if (std::ranges::find(lines, foreign.key, &KeyLine::key) != lines.end()) continue;
        SchemeLines wrong = lines;
        wrong.push_back(foreign);
        const auto column = static_cast<unsigned>(foreign.key.size()) + 4;
        expect_one_fault(
            file_text(type, wrong),
            scheme_line() + keys_after_scheme_line + static_cast<unsigned>(lines.size()), column,
            foreign.key + " belongs to a scheme of type ");
      }
    }
  }
}

struct WrongValue {
  const char* name;
  const char* type;
  const char* key;
  const char* value;
  const char* words;
};

void PrintTo(const WrongValue& wrong, std::ostream* stream) {
  *stream << wrong.name;
}

class WrongScheme : public ::testing::TestWithParam<WrongValue> {};

TEST_P(WrongScheme, NamesPlaceAndReason) {
  const WrongValue& wrong = GetParam();
  SchemeLines lines = valid_scheme(wrong.type);
  const auto key = std::ranges::find(lines, wrong.key, &KeyLine::key);
  ASSERT_NE(key, lines.end());
  key->value = wrong.value;
  const auto index = static_cast<unsigned>(key - lines.begin());
  expect_one_fault(file_text(wrong.type, lines), scheme_line() + keys_after_scheme_line + index,
                   static_cast<unsigned>(key->key.size()) + 4, wrong.words);
}

const WrongValue wrong_values[] = {
    {"ReadingUnknown", "lathe", "x_reading", "\"inch\"",
     "x_reading is 'inch'; it must be one of radius, diameter"},
    {"TurretUnknown", "lathe", "turret", "\"below\"",
     "turret is 'below'; it must be one of rear, front"},
    {"HeadAxisUnknown", "head_table", "head_axis", "\"A\"",
     "'A' is not an axis of the channel; its axes are X, Y, Z, B, C"},
    {"HeadAxisLinear", "head_table", "head_axis", "\"X\"",
     "axis 'X' is linear; head_axis must be a rotary axis"},
    {"TableAxisUnknown", "head_table", "table_axis", "\"C1\"",
     "'C1' is not an axis of the channel"},
    {"TableAxisLinear", "head_table", "table_axis", "\"Z\"",
     "axis 'Z' is linear; table_axis must be a rotary axis"},
    {"OuterAxisUnknown", "head_head", "outer_axis", "\"A\"", "'A' is not an axis of the channel"},
    {"OuterAxisLinear", "head_head", "outer_axis", "\"Y\"",
     "axis 'Y' is linear; outer_axis must be a rotary axis"},
    {"InnerAxisUnknown", "table_table", "inner_axis", "\"A\"", "'A' is not an axis of the channel"},
    {"InnerAxisLinear", "table_table", "inner_axis", "\"X\"",
     "axis 'X' is linear; inner_axis must be a rotary axis"},
    {"HeadVectorZero", "head_table", "head_vector", "[0, 0.0, 0]",
     "head_vector is 0, 0, 0; it must have a direction (direction of head_axis)"},
    {"TableVectorZero", "head_table", "table_vector", "[0, 0, 0]",
     "table_vector is 0, 0, 0; it must have a direction"},
    {"OuterVectorZero", "head_head", "outer_vector", "[0, 0, 0]",
     "outer_vector is 0, 0, 0; it must have a direction"},
    {"InnerVectorZero", "table_table", "inner_vector", "[0, 0, 0]",
     "inner_vector is 0, 0, 0; it must have a direction"},
    {"VectorTooShort", "table_table", "outer_vector", "[1, 0]",
     "outer_vector is a list; write a list of three numbers [x, y, z]"},
    {"PivotTooLong", "head_head", "pivot_to_pivot", "[1, 0, 0, 0]",
     "pivot_to_pivot is a list; write a list of three numbers [x, y, z]"},
    {"CentreTooShort", "table_table", "centre_to_centre", "[]",
     "centre_to_centre is a list; write a list of three numbers [x, y, z]"},
};

INSTANTIATE_TEST_SUITE_P(Values, WrongScheme, ::testing::ValuesIn(wrong_values),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

// The place is that of the component.
TEST(SchemeFaults, ComponentsOfVectorsAreFiniteNumbers) {
  SchemeLines lines = valid_scheme("head_table");
  lines[1].value = "[1, \"a\", 0]";
  const unsigned line = scheme_line() + keys_after_scheme_line;
  expect_one_fault(file_text("head_table", lines), line + 1, 19,
                   "head_vector is a text; write a list of three numbers [x, y, z]");
  lines = valid_scheme("head_table");
  lines[4].value = "[1, 0, inf]";
  expect_one_fault(file_text("head_table", lines), line + 4, 27, "pivot_to_spindle is not finite");
}

TEST(SchemeFaults, WhatTheTypeLacksIsSaidAtItsAxes) {
  const std::string parked = "[[channel.scheme.parked]]\naxis = \"X\"\n";
  const unsigned line = scheme_line() + 3;
  const std::string axes = R"(["Y", "Z", "B", "C"])";
  for (const auto& [type, words] :
       {std::pair("lathe", "lathe: X and Z must take part"),
        std::pair("head_table", "head_table: X, Y and Z must take part"),
        std::pair("head_head", "head_head: X, Y and Z must take part"),
        std::pair("table_table", "table_table: X, Y and Z must take part")}) {
    expect_one_fault(file_text(type, valid_scheme(type), axes) + parked, line, 8, words);
  }
  for (const auto& [type, words] :
       {std::pair("head_table", "head_table: head_axis and table_axis must differ"),
        std::pair("head_head", "head_head: outer_axis and inner_axis must differ"),
        std::pair("table_table", "table_table: outer_axis and inner_axis must differ")}) {
    SchemeLines lines = valid_scheme(type);
    for (KeyLine& each : lines) {
      if (each.key.ends_with("_axis")) each.value = "\"B\"";
    }
    expect_one_fault(file_text(type, lines), line, 8, words);
  }
}

TEST(SchemeFaults, TypesOfAProgramAreNoTypesOfAFile) {
  for (const std::string type : {"polar_face", "cylinder"}) {
    expect_one_fault(file_text(type, {}), scheme_line() + 2, 8,
                     "type is '" + type + "'; it must be one of cartesian, lathe, ");
  }
}

}  // namespace
}  // namespace stanok::config

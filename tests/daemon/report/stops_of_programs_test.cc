// What is shown at a stop is that of the block at which the channel stopped: the shipped programs
// block by block, each block being a stop, and the ways to stop that programs and operators have.
//
// What must be shown is read from the text of the programs, by a reader of its own that knows words
// and modal groups and nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/daemon/daemon_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

const std::string root = stanok::testing::source_folder();

struct Word {
  char letter = ' ';
  std::string number;  // as written; empty: an expression
};

// The words of a line of text, without comments and what is no block.
std::vector<Word> words_of(std::string line) {
  line = std::regex_replace(line, std::regex(R"(\([^()]*\)\s*$|//.*$)"), "");
  static const std::regex statement(
      R"(^\s*(#|for\b|if\b|while\b|num\b|\{|\}|[a-z_]+\s*(\(|=)|%|O<))");
  if (std::regex_search(line, statement)) return {};
  static const std::regex word(R"(([A-Z])(-?\d*\.?\d+)?(?=[A-Z=\s]|-?\d|$))");
  std::vector<Word> words;
  for (std::sregex_iterator at(line.begin(), line.end(), word), end; at != end; ++at)
    words.push_back({(*at)[1].str()[0], (*at)[2].str()});
  return words;
}

std::string code_of(const Word& word) {
  std::string number = word.number;
  while (number.size() > 1 && number[0] == '0') number.erase(0, 1);
  return word.letter + number;
}

// The modal groups that the shipped programs use; a code replaces the others of its row.
const std::vector<std::set<std::string>>& groups() {
  static const std::vector<std::set<std::string>> all{
      {"G0", "G1", "G2", "G3", "G33", "G76", "G80", "G81", "G82", "G83", "G84", "G85"},
      {"G17", "G18", "G19"},
      {"G20", "G21"},
      {"G7", "G8"},
      {"G90", "G91"},
      {"G93", "G94", "G95"},
      {"G96", "G97"},
      {"G54", "G55", "G56", "G57", "G58", "G59"},
      {"G43", "G43.4", "G49"},
      {"G40", "G41", "G42"},
      {"G61", "G61.1", "G64"},
      {"G12.1", "G7.1", "G13.1"},
      {"G68", "G68.2", "G69"},
      {"G98", "G99"},
  };
  return all;
}

// What the text of the lines so far leaves in force.
class TextState {
 public:
  explicit TextState(const channels::ChannelConfig& channel) : channel_(channel) {}

  void read(const std::string& line) {
    const std::vector<Word> words = words_of(line);
    const bool is_of_other_spindle = line.find('$') != std::string::npos;
    for (const Word& word : words) {
      if (word.letter == 'G') take(code_of(word));
      if (word.letter == 'M' && !is_of_other_spindle) switch_to(code_of(word));
      if (word.letter == 'T' && !word.number.empty()) prepared_ = std::stoi(word.number);
    }
    for (const Word& word : words) {
      const bool changes = code_of(word) == "M6" || channel_.tool_change == "t_word";
      const bool is_change = word.letter == (channel_.tool_change == "t_word" ? 'T' : 'M');
      if (changes && is_change && prepared_) tool_ = prepared_;
    }
    if (is_of_other_spindle || spindle_is_axis_) spindle_.reset();
  }
  // In words, what the status says otherwise; empty: nothing.
  [[nodiscard]] std::string difference(const json& status) const {
    std::string found;
    const auto all = status["g_codes"].get<std::set<std::string>>();
    for (const auto& [group, code] : codes_) {
      if (!all.contains(code)) found += " no " + code;
    }
    if (status["coolant"].get<std::set<std::string>>() != coolant_) found += " coolant";
    if (spindle_ && !status["m_codes"].get<std::set<std::string>>().contains(*spindle_))
      found += " no " + *spindle_;
    if (tool_ && status["tool"]["number"] != tool()) found += " tool";
    if (offset_ && status["work_offset"] != *offset_) found += " work offset";
    if (units_ && status["units"] != *units_) found += " units";
    if (diameter_ && (!status["diameter"].empty()) != *diameter_) found += " diameter";
    return found;
  }
  // 0: none.
  [[nodiscard]] int tool() const {
    return channel_.t_format == "tool_edge" ? tool_.value_or(0) / 100 : tool_.value_or(0);
  }
  // Whether a literal word of an axis is the coordinate that the display must have.
  [[nodiscard]] bool shows_literals() const {
    const auto is = [&](std::size_t group, const std::set<std::string>& codes) {
      const auto code = codes_.find(group);
      return code == codes_.end() || codes.contains(code->second);
    };
    return is(4, {"G90"}) && is(9, {"G40"}) && is(0, {"G0", "G1", "G2", "G3"});
  }

 private:
  void take(const std::string& code) {
    for (std::size_t k = 0; k < groups().size(); ++k) {
      if (groups()[k].contains(code)) codes_[k] = code;
    }
    if (groups()[7].contains(code)) offset_ = code;
    if (groups()[2].contains(code)) units_ = code == "G20" ? "inch" : "mm";
    if (groups()[3].contains(code)) diameter_ = code == "G7";
  }
  void switch_to(const std::string& code) {
    if (code == "M7") coolant_.insert("mist");
    if (code == "M8") coolant_.insert("flood");
    if (code == "M9") coolant_.clear();
    if (code == "M3" || code == "M4" || code == "M5") spindle_ = code;
    if (code == "M902") spindle_is_axis_ = true;
    if (code == "M903") spindle_is_axis_ = false;
  }

  const channels::ChannelConfig& channel_;
  std::map<std::size_t, std::string> codes_;  // by group
  std::optional<int> prepared_;
  std::optional<int> tool_;
  std::set<std::string> coolant_;
  std::optional<std::string> spindle_;
  bool spindle_is_axis_ = false;
  std::optional<std::string> offset_;
  std::optional<std::string> units_;
  std::optional<bool> diameter_;
};

// The lines between two stops, in the order of their execution: on to the next one, or through the
// end of the loop around it to its beginning.
std::vector<std::size_t> lines_between(const std::vector<std::string>& lines, std::size_t last,
                                       std::size_t next) {
  std::vector<std::size_t> passed;
  std::size_t from = last + 1;
  if (next <= last) {
    const auto depth_at = [&](std::size_t from_line, std::size_t line) {
      int depth = 0;
      for (std::size_t k = from_line; k <= line; ++k)
        depth += lines[k - 1].starts_with('{') || lines[k - 1].find("  {") == 0 ? 1
                 : lines[k - 1].find('}') != std::string::npos                  ? -1
                                                                                : 0;
      return depth;
    };
    std::size_t begin = next;
    while (begin > 1 && depth_at(begin, last) < 1) --begin;
    std::size_t end = last;
    while (end < lines.size() && depth_at(begin, end) > 0) ++end;
    for (std::size_t k = from; k < end; ++k) passed.push_back(k);
    from = begin;
  }
  for (std::size_t k = from; k <= next; ++k) passed.push_back(k);
  return passed;
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The words of axes with a number, where the block goes to them: what the position must be.
std::map<std::string, double> literals_of(const std::string& line) {
  std::map<std::string, double> values;
  static const std::set<std::string> others{"G28",   "G53",   "G92",   "G10", "G52",
                                            "G68",   "G68.2", "G4",    "G76", "G33",
                                            "G12.1", "G7.1",  "G13.1", "G51", "G64"};
  for (const Word& word : words_of(line)) {
    if (word.letter == 'G' && others.contains(code_of(word))) return {};
    if (std::string("XYZABC").find(word.letter) == std::string::npos) continue;
    if (!word.number.empty()) values[std::string(1, word.letter)] = std::stod(word.number);
  }
  return values;
}

struct Shipped {
  const char* program;
  const char* machine;
  const char* scheme = "";
};

void PrintTo(const Shipped& shipped, std::ostream* out) {
  *out << shipped.program << " on " << shipped.machine;
}

// Whether the corners of the program are rounded, as it says, or it goes exactly through them.
enum class Corners : std::uint8_t { as_shipped, exact };

// The path and with it a stop lie within the tolerance of a rounded corner; in G61.1 a block ends
// where its words say.
std::vector<std::string> with_exact_corners(std::vector<std::string> lines) {
  for (std::string& line : lines) {
    line = std::regex_replace(line, std::regex(R"(G64( P[0-9.]+)?)"), "G61.1");
    if (line.starts_with("N10 ") && line.find("G61") == std::string::npos) line += " G61.1";
  }
  return lines;
}

class StopsOf : public ::testing::TestWithParam<Shipped> {};

json status_of(DaemonBench& bench) {
  const auto answer = bench.answer("channel.status");
  return answer && *answer ? **answer : json();
}

// Until the channel stands: at a stop, or because the run is over.
json next_stop(DaemonBench& bench) {
  constexpr int cycles_max = 3'000'000;
  for (int n = 0; n < cycles_max; ++n) {
    const channels::ChannelOutput& now = bench.cycle().channels[0];
    if (now.state == channels::ChannelState::running) continue;
    if (now.state == channels::ChannelState::held && now.moving) continue;
    return status_of(bench);
  }
  ADD_FAILURE() << "no stop";
  return {};
}

// Behind the end of a program: the default state, with the tool that is in place.
void expect_end(const json& before, const json& status, int tool) {
  EXPECT_EQ(status["line"], 0);
  EXPECT_TRUE(status["file"].is_null());
  for (const char* member : {"g_codes", "m_codes", "work_offset", "coolant", "units", "diameter"})
    EXPECT_EQ(status[member], before[member]) << member;
  EXPECT_EQ(status["tool"]["number"], tool);
}

void follow(const Shipped& shipped, Corners corners) {
  const config::MachineFile file =
      config::read_machine_file(root + "/config/machines/" + shipped.machine + ".toml");
  DaemonBench bench(file);
  for (const auto& entry : std::filesystem::directory_iterator(root + "/programs/examples")) {
    if (entry.path().extension() == ".nc")
      std::filesystem::copy_file(entry.path(), bench.folder() / entry.path().filename());
  }
  bench.demand("machine.on");
  bench.cycles(300);
  if (*shipped.scheme != '\0')
    bench.demand("kinematics.select", {{"scheme", std::stoi(shipped.scheme)}});
  const std::string program = std::string(shipped.program) + ".nc";
  std::vector<std::string> lines = lines_of(bench.folder() / program);
  if (corners == Corners::exact) lines = with_exact_corners(lines);
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  bench.program(program, all);
  bench.demand("program.load", {{"program", program}});
  bench.demand("program.step", {{"on", 1}});
  TextState text(file.machine.channels[0]);
  const json before = status_of(bench);
  std::size_t last = 0;
  std::uint64_t block = 0;
  int stops = 0;
  int compared = 0;
  while (true) {
    bench.demand("program.start");
    const json status = next_stop(bench);
    if (status["state"] != "Interrupted") {
      ASSERT_TRUE(status["alarm"].is_null()) << status["alarm"];
      expect_end(before, status, text.tool());
      break;
    }
    ++stops;
    const auto line = status["line"].get<std::size_t>();
    ASSERT_TRUE(status["block"] > block || line > last) << "twice at line " << line;
    block = status["block"];
    ASSERT_EQ(status["file"], program);
    ASSERT_GE(line, 1u);
    ASSERT_LE(line, lines.size());
    for (const std::size_t passed : lines_between(lines, last, line)) text.read(lines[passed - 1]);
    last = line;
    ASSERT_EQ(text.difference(status), "") << "line " << line << ": " << lines[line - 1] << "\n"
                                           << status.dump(1);
    if (corners == Corners::as_shipped || !text.shows_literals()) continue;
    for (const auto& [word, value] : literals_of(lines[line - 1])) {
      if (!status["position"].contains(word)) continue;
      ++compared;
      const double off = status["position"][word].get<double>() - value;
      const bool is_angle = word == "A" || word == "B" || word == "C";
      ASSERT_NEAR(is_angle ? std::remainder(off, 360.0) : off, 0.0, 1e-9)
          << "line " << line << ": " << lines[line - 1];
    }
  }
  std::cout << program << ": " << stops << " stops, " << compared << " coordinates\n";
  EXPECT_GT(stops, 5);
}

TEST_P(StopsOf, AreShownAsTheirBlocksSay) {
  follow(GetParam(), Corners::as_shipped);
}

std::string name_of(const ::testing::TestParamInfo<Shipped>& shipped) {
  return std::string(shipped.param.program) + "_on_" + shipped.param.machine;
}

class WordsAtStopsOf : public StopsOf {};

TEST_P(WordsAtStopsOf, LeadToWhereTheBlocksEnd) {
  follow(GetParam(), Corners::exact);
}

constexpr Shipped rounded_programs[] = {
    {"square_and_circle", "mill3"},
    {"helix", "mill3"},
    {"bolt_circle", "mill3"},
    {"tilted_pocket", "e7106mf4", "2"},
    {"trunnion", "trunnion"},
    {"lathe", "lathe"},
    {"thread", "lathe"},
    {"chip_breaking", "lathe"},
    {"slender_shaft", "lathe"},
    {"plunge_grinding", "grinder"},
    {"workpiece", "e7106mf4"},
    {"turned_part", "lathe"},
    {"adaptive_steps", "lathe"},
    {"millturn4", "millturn4"},
};
constexpr Shipped exact_programs[] = {
    {"square_and_circle", "mill3"},
    {"helix", "mill3"},
    {"bolt_circle", "mill3"},
    {"tilted_pocket", "e7106mf4", "2"},
    {"trunnion", "trunnion"},
    {"lathe", "lathe"},
    {"thread", "lathe"},
    {"plunge_grinding", "grinder"},
};
INSTANTIATE_TEST_SUITE_P(Shipped, StopsOf, ::testing::ValuesIn(rounded_programs), name_of);
INSTANTIATE_TEST_SUITE_P(Shipped, WordsAtStopsOf, ::testing::ValuesIn(exact_programs), name_of);

// The other ways to stop: by the program, with and without its switch, by hand within a block, and
// for good.
TEST(WaysToStop, ShowTheBlockAtWhichTheChannelStands) {
  DaemonBench bench;
  const std::vector<std::string> lines{"G21 G90 G94 G54",  // 1
                                       "T1 M6",            // 2
                                       "M8",               // 3
                                       "G1 X5 F6000",      // 4
                                       "M9",               // 5
                                       "M0",               // 6
                                       "M7 S500 M3",       // 7
                                       "G55",              // 8
                                       "M1",               // 9
                                       "M60",              // 10
                                       "G1 X10 F300",      // 11
                                       "M30"};             // 12
  std::string program;
  for (const std::string& line : lines) program += line + "\n";
  bench.program("p.nc", program);
  bench.demand("machine.on");
  bench.cycles(300);
  const json before = status_of(bench);
  bench.demand("program.optional_stop", {{"on", 1}});
  bench.demand("program.load", {{"program", "p.nc"}});
  TextState text(mill_of_the_bench().machine.channels[0]);
  std::size_t read = 0;
  const auto expect_at = [&](std::size_t line, const char* held_by) {
    const json status = next_stop(bench);
    while (read < line) text.read(lines[read++]);
    EXPECT_EQ(status["line"], line);
    EXPECT_EQ(status["file"], "p.nc");
    EXPECT_EQ(status["held_by"], held_by);
    EXPECT_EQ(text.difference(status), "") << status.dump(1);
  };
  bench.demand("program.start");
  expect_at(6, "program stop");
  bench.demand("program.start");
  expect_at(9, "program stop");
  bench.demand("program.start");
  expect_at(10, "program stop");
  bench.demand("program.start");
  while (bench.channel(1).point_W[0].value < 7.0) bench.cycle();
  bench.demand("program.hold");
  expect_at(11, "feed hold by an operator");
  bench.demand("program.stop");
  expect_end(before, next_stop(bench), 1);
}

}  // namespace
}  // namespace stanok::daemon

// Texts that are not UTF-8: whatever stands in a program or in the name of a file, each tool of the
// real `stanok` prints valid UTF-8, and with --json valid JSON.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/utf8.h"
#include "tests/client/stanok_program.h"
#include "tests/support/sanitized.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string mill = stanok::testing::source_folder() + "/config/machines/mill3.toml";
// "Деталь" in CP1251.
const std::string cp1251 = "\xC4\xE5\xF2\xE0\xEB\xFC";
// 300 letters of two bytes: longer than a text of an event.
const std::string long_text = [] {
  std::string text = "a";
  for (int i = 0; i < 300; ++i) text += "\xD0\xA4";
  return text;
}();

std::string text_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Printed {
  int exit_code = 0;
  std::string data;
  std::string messages;
};

class TextEncoding : public ::testing::Test {
 protected:
  TextEncoding() {
    std::string pattern = (fs::temp_directory_path() / "stanok-text-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~TextEncoding() override { fs::remove_all(folder_); }

  std::string program(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  // Both streams are looked at: no byte of them is anything but UTF-8.
  Printed run(const std::string& arguments) {
    const fs::path data = folder_ / "data.out";
    const fs::path messages = folder_ / "messages.out";
    const std::string command = stanok_program + " " + arguments + " >" + data.string() + " 2>" +
                                messages.string() + " </dev/null";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << arguments;
    Printed done{WEXITSTATUS(status), text_in(data), text_in(messages)};
    EXPECT_TRUE(is_utf8(done.data)) << arguments << ": " << done.data;
    EXPECT_TRUE(is_utf8(done.messages)) << arguments << ": " << done.messages;
    return done;
  }
  // Every line is a JSON text: the parser refuses what is no UTF-8.
  static std::vector<json> lines_of(const Printed& run) {
    std::istringstream stream(run.data);
    std::vector<json> lines;
    for (std::string line; std::getline(stream, line);) {
      json value = json::parse(line, nullptr, false);
      EXPECT_FALSE(value.is_discarded()) << line;
      lines.push_back(std::move(value));
    }
    EXPECT_FALSE(lines.empty());
    return lines;
  }

  fs::path folder_;
};

// The text in each place from which it can reach an output.
std::vector<std::string> programs_with(const std::string& text) {
  return {
      "(" + text + ")\nG0 X1\nM30\n",
      "; " + text + "\n(MSG," + text + ")\nG0 X1\nM30\n",
      "msg (\"" + text + "\");\nwarn (\"" + text + "\");\nG0 X1\nM30\n",
      "terminate (1001, \"" + text + "\");\nM30\n",
      "G0 X1 " + text + "\nM30\n",
      "#include \"" + text + ".nc\"\nM30\n",
      "call (\"" + text + ".nc\");\nM30\n",
      "string " + text + " = 1;\nM30\n",
      "channel_load (1, \"" + text + ".nc\");\nM30\n",
      "string t = substr (\"" + text + "\", 1, 3);\nmsg (t);\nM30\n",
      "// " + text + "\nnum aa = \"" + text + "\";\nM30\n",
  };
}

const std::vector<std::string>& texts() {
  static const std::vector<std::string> all = {cp1251, "cut \xD0", "\xF0\x9F\x94", long_text};
  return all;
}

TEST_F(TextEncoding, OfAProgramNeverMakesAnOutputInvalid) {
  for (std::size_t k = 0; k < stanok::testing::cases(texts().size()); ++k) {
    for (const std::string& source : programs_with(texts()[k])) {
      const std::string file = program("part.nc", source) + " --machine " + mill;
      SCOPED_TRACE(valid_utf8(source));
      run("check " + file);
      const Printed checked = run("check --json " + file);
      EXPECT_TRUE(lines_of(checked).front().is_array());
      EXPECT_TRUE(checked.exit_code == 0 || checked.exit_code == 6) << checked.exit_code;
      const Printed interpreted = run("interpret " + file);
      if (interpreted.exit_code == 0) lines_of(interpreted);
      const Printed simulated = run("simulate --json " + file);
      EXPECT_TRUE(lines_of(simulated).front().is_object());
      EXPECT_TRUE(simulated.exit_code == 0 || simulated.exit_code == 6) << simulated.exit_code;
    }
  }
}

TEST_F(TextEncoding, IsToldOnceAndTheTextIsShownWithReplacements) {
  const std::string file =
      program("part.nc", "(MSG," + cp1251 + ")\nG0 X1\nM30\n") + " --machine " + mill;
  const json found = lines_of(run("check --json " + file)).front();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]["code"], "W110");
  EXPECT_EQ(found[0]["column"], 6);
  std::string shown;
  for (int i = 0; i < 6; ++i) shown += replacement_character;
  const auto records = lines_of(run("interpret " + file));
  EXPECT_TRUE(std::any_of(records.begin(), records.end(), [&](const json& record) {
    return record["kind"] == "message" && record["text"] == shown;
  }));
  EXPECT_NE(run("simulate " + file).messages.find(shown), std::string::npos);
}

TEST_F(TextEncoding, OfAMessageIsKeptWhenItIsUtf8AndCutBetweenCharacters) {
  const std::string file =
      program("part.nc", "msg (\"" + long_text + "\");\nM30\n") + " --machine " + mill;
  const Printed simulated = run("simulate " + file);
  EXPECT_EQ(simulated.exit_code, 0);
  EXPECT_NE(simulated.messages.find(long_text.substr(0, 201)), std::string::npos);
  EXPECT_EQ(simulated.messages.find(replacement_character), std::string::npos);
}

TEST_F(TextEncoding, OfAFileNameIsRepairedInEveryOutputAndTheFileRuns) {
  const std::string name = cp1251 + ".nc";
  const std::string file = "'" + program(name, "G0 X1\nX Q\nM30\n") + "' --machine " + mill;
  EXPECT_EQ(lines_of(run("check --json " + file)).front()[0]["file"], valid_utf8(name));
  run("check " + file);
  run("simulate --json " + file);
  run("interpret " + file);
  program(name, "G0 X1\nM30\n");
  const fs::path log = folder_ / "run.lcm";
  const Printed simulated = run("simulate --json " + file + " --log " + log.string());
  EXPECT_EQ(simulated.exit_code, 0);
  const json result = lines_of(simulated).front();
  EXPECT_EQ(result["channels"][0]["runs"][0]["program"], valid_utf8(name));
  EXPECT_EQ(run("log verify " + log.string()).exit_code, 0);
  run("check " + folder_.string() + " --machine " + mill);
  lines_of(run("check --json " + folder_.string() + " --machine " + mill));
}

TEST_F(TextEncoding, OfTheCommandLineIsRepairedInWhatIsSaidAboutIt) {
  EXPECT_EQ(run("'" + cp1251 + "'").exit_code, 2);
  EXPECT_EQ(run("explain '" + cp1251 + "'").exit_code, 1);
  EXPECT_EQ(run("check '" + cp1251 + ".nc' --machine " + mill).exit_code, 6);
  EXPECT_EQ(run("check a.nc --machine '" + cp1251 + "'").exit_code, 1);
  EXPECT_EQ(run("log info '" + cp1251 + "'").exit_code, 1);
  EXPECT_EQ(run("--socket /nonexistent/'" + cp1251 + "' machine status").exit_code, 3);
}

TEST_F(TextEncoding, OfAMachineFileIsAnErrorWithItsPlace) {
  const std::string machine = program("m.toml", "[machine]\nname = \"" + cp1251 + "\"\n");
  EXPECT_EQ(run("machine check " + machine).exit_code, 1);
  EXPECT_EQ(run("machine check --json " + machine).exit_code, 1);
}

}  // namespace
}  // namespace stanok::client

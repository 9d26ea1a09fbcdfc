// The manual pages: every command, parameter and option stands in them, and their text is taken as
// it is. That man and mandoc accept them is tested in tests/manual_test.sh.
#include "client/command_line/manual_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "client/command_line/offline.h"
#include "client/command_line/roff.h"
#include "client/operator/operator_commands.h"
#include "protocol/contract/method_table.h"
#include "tests/support/project_folders.h"

namespace stanok::client {
namespace {

class ManualPages : public ::testing::Test {
 protected:
  ManualPages() {
    add_operator_commands(app, [](const OperatorCall&) {});
    add_offline_commands(app, exit_code);
    pages = manual_pages(app);
  }
  std::string page(std::string_view name) const {
    const auto found = std::find_if(pages.begin(), pages.end(),
                                    [&](const ManualPage& one) { return one.name == name; });
    return found == pages.end() ? "" : found->text;
  }
  CLI::App app;
  int exit_code = 0;
  std::vector<ManualPage> pages;
};

TEST_F(ManualPages, DescribeEveryMethodAndItsParameters) {
  for (const protocol::Method& method : protocol::methods()) {
    const std::string text = page("stanok-" + std::string(protocol::noun(method)));
    std::string path = "stanok " + std::string(method.name);
    std::replace(path.begin(), path.end(), '.', ' ');
    EXPECT_NE(text.find("\n" + roff::bold(path)), std::string::npos) << path;
    EXPECT_NE(text.find(roff::escaped(method.help.substr(1))), std::string::npos) << path;
    for (const protocol::Parameter& parameter : method.parameters) {
      std::string name(parameter.name);
      std::replace(name.begin(), name.end(), '_', '-');
      const bool is_argument = parameter.spelling == protocol::Spelling::positional ||
                               parameter.spelling == protocol::Spelling::file;
      if (is_argument) {
        std::transform(name.begin(), name.end(), name.begin(), ::toupper);
        EXPECT_NE(text.find(".TP\n" + roff::italic(name)), std::string::npos) << path << name;
      } else {
        EXPECT_NE(text.find(".TP\n" + roff::bold("--" + name)), std::string::npos) << path << name;
      }
    }
  }
}

TEST_F(ManualPages, OfTheOffLineJobsAreThereToo) {
  EXPECT_NE(page("stanok-simulate").find(roff::bold("--until") + " " + roff::italic("FLOAT")),
            std::string::npos);
  EXPECT_NE(page("stanok-log").find(".SS stanok log verify\n"), std::string::npos);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    EXPECT_NE(page("stanok").find("stanok\\-" + command->get_name() + "\\fR(1)"), std::string::npos)
        << command->get_name();
}

// What must be given stands without brackets.
TEST_F(ManualPages, ShowWhatMayBeLeftOut) {
  const std::string jog = page("stanok-jog");
  EXPECT_NE(jog.find(" \\fB\\-\\-velocity\\fR \\fI"), std::string::npos);
  EXPECT_EQ(jog.find("[\\fB\\-\\-velocity"), std::string::npos);
  EXPECT_NE(jog.find("[\\fB\\-\\-increment"), std::string::npos);
  EXPECT_NE(jog.find(" \\fIAXIS\\fR\n"), std::string::npos);
}

std::string without_marks(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(`|\\)"), "");
}

TEST_F(ManualPages, TellTheExitCodesOfTheDocument) {
  std::ifstream file(stanok::testing::source_folder() + "/docs/reference/command-line.md");
  std::stringstream document;
  document << file.rdbuf();
  const std::string main_page = without_marks(page("stanok"));
  const std::string text = document.str();
  const std::string section = text.substr(text.find("## Exit codes"));
  const std::regex row(R"(\n\| (\d+) \| ([^|]*) \|)");
  const std::string table = section.substr(0, section.find("\n## ", 1));
  int count = 0;
  for (std::sregex_iterator found(table.begin(), table.end(), row); found != std::sregex_iterator();
       ++found, ++count) {
    const std::string wanted =
        ".TP\nfB" + (*found)[1].str() + "fR\n" + without_marks((*found)[2].str()) + "\n";
    EXPECT_NE(main_page.find(wanted), std::string::npos) << wanted;
  }
  EXPECT_GE(count, 9);
}

TEST(Roff, TakesNothingOfATextForARequestOrASign) {
  EXPECT_EQ(roff::escaped("plain text, 1.5 mm"), "plain text, 1.5 mm");
  EXPECT_EQ(roff::escaped(".nc files"), "\\&.nc files");
  EXPECT_EQ(roff::escaped("'a' ~/b --c \\d ^ `"), "\\(aqa\\(aq \\(ti/b \\-\\-c \\ed \\(ha \\(ga");
}

}  // namespace
}  // namespace stanok::client

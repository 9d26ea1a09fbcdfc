// docs/reference/alarms.md is the catalogue as a document. After a change of the catalogue write it
// anew with
//   STANOK_WRITE_DOCS=1 build/dev/tests/base_tests --gtest_filter='AlarmsDocument.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/catalogue.h"
#include "tests/support/project_folders.h"

namespace stanok {
namespace {

const std::filesystem::path document =
    std::filesystem::path(stanok::testing::source_folder()) / "docs/reference/alarms.md";

constexpr std::string_view introduction =
    R"(# Codes of errors, warnings and alarms

Made from [base/catalogue.cc](../../base/catalogue.cc) and
[base/catalogue_rows](../../base/catalogue_rows). `stanok explain CODE` prints one row.
E: error of a program or command. W: warning. A: alarm of the machine. U1000 to U9999: `terminate`
in a program, with its own text. A code never changes its meaning.

Reactions: **1** nothing stops · **2** the program ends after the prepared blocks · **3** the
program ends immediately · **4** feed hold of the channel · **5** the faulty axis stops, the others
hold · **6** all axes off.

| code | what | reaction | remedy | how to go on |
|---|---|---|---|---|
)";

std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped + " | ";
}

std::string alarms_document() {
  std::string text(introduction);
  for (const CatalogueRow& row : catalogue()) {
    text += "| " + cell(row.code) + cell(row.title) +
            cell(std::to_string(static_cast<int>(row.reaction))) + cell(row.remedy) +
            cell(row.go_on);
    text.back() = '\n';
  }
  return text;
}

TEST(AlarmsDocument, IsWhatTheCatalogueSays) {
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) std::ofstream(document) << alarms_document();
  std::ifstream stream(document);
  std::stringstream written;
  written << stream.rdbuf();
  EXPECT_EQ(written.str(), alarms_document()) << "write it anew as described in this file";
}

}  // namespace
}  // namespace stanok

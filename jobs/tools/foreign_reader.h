// ForeignReader gathers the tools of one foreign file, what is wrong in it and what is not carried;
// a reader of a format goes on after a fault.
//
// A value goes to a key of the tables file and is held to that key's range, so that what is
// imported can be loaded.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/text/config_error.h"
#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

// Where something is in the file. Line and column count from 1; line 0: in the file.
struct ForeignPlace {
  unsigned line = 0;
  unsigned column = 0;
  std::string member{};  // path of a member in a file of JSON
  std::string file{};    // another one, which the file names or has in it; empty: the file itself
};

class ForeignReader {
 public:
  explicit ForeignReader(const ForeignSource& source) : file_(source.file.string()) {}

  void fault(const ForeignPlace& place, const std::string& text);
  void lose(NotCarried lost) { found_.not_carried.push_back(std::move(lost)); }
  void remark(std::string text) { found_.remarks.push_back(std::move(text)); }

  // A tool that comes once. Null when it has come before, which is a fault, or when stanok has no
  // such number or edge: then all of it is not carried.
  [[nodiscard]] ForeignTool* begin(int number, int edge, const ForeignPlace& place);
  // A tool whose values are spread over the file. Null as above.
  [[nodiscard]] ForeignTool* tool(int number, const ForeignPlace& place);

  // Values: mm, deg, or a whole number. A fault when the key cannot have it.
  void give(ForeignTool& tool, std::string_view key, double value, const ForeignPlace& place);
  void give_text(ForeignTool& tool, std::string_view key, std::string_view text);

  // Throws ConfigError where there were faults, or no tool at all.
  [[nodiscard]] ForeignTools finish();

 private:
  [[nodiscard]] bool has_number(int number, int edge);
  void check_corners();

  std::string file_;
  std::vector<config::ConfigFault> faults_;
  ForeignTools found_;
  std::map<std::pair<int, int>, ForeignTool> tools_;
  std::map<std::pair<int, int>, ForeignPlace> places_;
};

[[nodiscard]] bool is_given(const ForeignTool& tool, std::string_view key);

}  // namespace stanok::jobs

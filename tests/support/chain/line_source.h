// Random lines as an operator types them.
//
// Each line is chosen where the axes stand then, so that most stay within the travel. A third of
// the moves are incremental; everything that gives words their meaning is changed between them:
// work offsets, G52, G92, rotation, planes, scaling, mirror, polar words, units, diameters, lengths
// of every kind, tool centre point, face and cylinder, tools, rows of both tables, stored points,
// cycles and probing.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "tests/support/chain/random_program.h"

namespace stanok::testing {

// How often a word of each class was in a line that the machine took.
using WordCounts = std::map<std::string, int>;

class LineSource {
 public:
  // `channel` is one of the machine's. Classes that `counts` has least of are drawn more often.
  LineSource(const channels::MachineConfig& machine, Choices& choices, int channel = 1,
             WordCounts counts = {});
  LineSource(const LineSource&) = delete;
  LineSource& operator=(const LineSource&) = delete;

  // The first line of a session: the same state whatever the kind of machine, in mid-travel.
  [[nodiscard]] std::string first() const;
  // `shown`: the words that lead to where the axes stand.
  [[nodiscard]] std::string next(const lang::AxisValues& shown);
  // The machine has taken the last line.
  void taken();
  // The last line wants another one behind it.
  [[nodiscard]] bool goes_on() const { return !next_.empty(); }
  [[nodiscard]] const WordCounts& counts() const { return counts_; }

 private:
  struct WordClass {
    std::string name;
    std::function<std::string()> line;
    std::string ends_with;  // a line that leaves the mode which it begins; empty: it begins none
    std::string within;     // the mode in which it has a meaning; empty: in all
  };

  void add(std::string name, std::function<std::string()> line, std::string ends_with = "",
           std::string within = "");
  void add_moves();
  void add_offsets();
  void add_tools();
  void add_rows_of_tools();
  void add_lengths();
  void add_frames();
  void add_modes();
  [[nodiscard]] const WordClass& drawn_class();
  [[nodiscard]] bool is_in(const std::string& mode) const;
  [[nodiscard]] std::string move(const std::string& code);
  [[nodiscard]] std::string increments();
  [[nodiscard]] std::string row_of_tool(const std::string& code, double low, double high);
  // Words of one to all of these letters that the channel has.
  [[nodiscard]] std::string words(const std::string& letters, double low, double high);
  [[nodiscard]] std::string any_of(const std::vector<std::string>& texts);
  [[nodiscard]] std::string any_tool();
  [[nodiscard]] std::string any_page();
  [[nodiscard]] bool has(const std::string& word) const;
  [[nodiscard]] double shown(const std::string& word) const;
  [[nodiscard]] const channels::AxisConfig& axis_of(const std::string& word) const;
  // A place in the middle of the travel, in M.
  [[nodiscard]] double middle_of(const std::string& word) const;

  const channels::MachineConfig& machine_;
  const channels::ChannelConfig& channel_;
  Choices& choices_;
  std::vector<WordClass> classes_;
  WordCounts counts_;
  lang::AxisValues shown_{};
  std::string then_;  // what comes behind the line, when the machine takes that
  std::string next_;
  const WordClass* last_ = nullptr;
  bool last_is_end_ = false;
  std::vector<const WordClass*> modes_;  // that lines have begun and none has left
};

}  // namespace stanok::testing

// Block search: where a run of a program begins or goes on, and what lies before that place.
//
// Without calculation the run begins at the place with the default modal state. With calculation
// all before it is interpreted and nothing of it is executed; what an operator has to know of it
// is collected in a SearchState. (docs/reference/language.md, "Block search")
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "lang/contract/command.h"

namespace stanok::lang {

class Program;

struct SearchTarget {
  std::string file;                   // as in diagnostics; empty: the program itself
  std::optional<std::uint32_t> line;  // 1-based; or
  std::optional<int> block_number;    // N; or
  std::optional<std::size_t> offset;  // byte of the file, from 0
  std::vector<std::uint32_t> calls;   // lines of the calls that lead there, outermost first
  int passes = 1;                     // the target is met for the n-th time
};

// The line at which a run shall stop before it executes anything of it.
struct StopPlace {
  std::uint16_t file = 0;
  std::uint32_t line = 0;
  std::vector<std::uint32_t> calls;  // empty: by whatever way
  int passes = 1;
};

// A target in an operator's words: "120", "N40", and in another file "sub.nc:120", "sub.nc:N40".
// Nothing: it is none.
[[nodiscard]] std::optional<SearchTarget> search_target(std::string_view text);

// Where the target stands; a line without code means the next one with code. The error is E6040.
[[nodiscard]] Expected<StopPlace, Diagnostic> find_place(const Program& program,
                                                         const SearchTarget& target);

// What the blocks before the target left in force, and what of them was not executed.
struct SearchState {
  bool calculated = false;  // else nothing was collected
  AxisValues position_W{};
  ToolLength length;
  FrameChange frame;
  std::map<int, SpindleCommand> spindles;  // the last command of each
  std::map<int, double> speeds;            // rev/min
  std::map<int, CuttingSpeedMode> cutting_speeds;
  std::set<int> spindles_as_axes;  // M902 without M903
  CoolantCommand coolant;
  OverrideControl overrides;
  std::vector<ForceControl> force_commands;  // in force, one of a kind
  FeedLaw feed_law;                          // modal
  int tool_prepared = 0;
  int tool = 0;
  bool tool_changed = false;

  struct Omission {
    std::string what;  // "table writes"
    int count = 0;
    Origin first;
  };
  std::vector<Omission> omissions;  // in the order in which they came first
};

// Takes the commands of a search in their order.
class SearchCollector {
 public:
  // What a request comes to: nothing when its answer cannot be known, which ends the search.
  [[nodiscard]] std::optional<Answer> answer(const ProgramRequest& request) const;

  void take(const Command& command);

  [[nodiscard]] const SearchState& state() const { return state_; }

 private:
  void take(const SpindleCommand& command);
  void take(const ForceControl& order);
  void take(const ProgramRequest& request, const Origin& origin);
  void omit(const std::string& what, const Origin& origin);

  SearchState state_;
};

// Why a search ended before its target (E6041): at a request whose answer only the machine knows;
// because the program was over.
[[nodiscard]] Diagnostic answer_is_unknown(const Program& program, const Origin& origin);
[[nodiscard]] Diagnostic ended_before(const Program& program, const StopPlace& place);

}  // namespace stanok::lang

// The RS274 parameters of a run: #n, #<name>, R, and the value that an O-subprogram returned.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns all values that programs set;
// numbers and names that show the state of the machine are read from what lies around the blocks.
// A vacant variable of the Fanuc dialect is NaN. Invariants: global names (#<_name>) and R
// parameters last from run to run, all others begin new; a named value is NaN until it is set.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/block/predefined_parameter.h"
#include "lang/program/program.h"
#include "lang/tree/text_value.h"
#include "lang/words/named_parameter.h"

namespace stanok::lang {

// #1 to #30 belong to a call of an O-line or G65, in the Fanuc dialect #1 to #33.
inline constexpr std::size_t local_parameter_count = 30;
inline constexpr std::size_t local_variable_count = 33;

// RS274 parameters that belong to one call: #1 to #30 (or #33) and #<name>.
struct LocalParameters {
  std::array<double, local_variable_count> numbered{};
  std::size_t count = local_parameter_count;
  std::vector<double> named;  // by slot; global ones are not used
};

// Where a run stands, for the parameters that show it.
struct WhereItRuns {
  Origin origin;
  int call_level = 0;  // 0: main program
  TextRules rules;     // of the text
};
class RunPlace {
 public:
  RunPlace() = default;
  RunPlace(const RunPlace&) = delete;
  RunPlace& operator=(const RunPlace&) = delete;
  virtual ~RunPlace() = default;

  [[nodiscard]] virtual WhereItRuns where() const = 0;
};

class ParameterStore final : public Parameters {
 public:
  // Both must outlive this.
  ParameterStore(const BlockSurroundings& around, const RunPlace& place);

  // A run of `program` begins.
  void begin(const std::shared_ptr<const Program>& program);

  std::optional<double> numbered(double number, ValueFault& fault) override;
  std::optional<double> named(const std::string& name, ValueFault& fault) override;
  std::optional<std::uint32_t> slot_to_set(const std::string& name) override;
  // The value of a slot, of a row of predefined_parameters(), and of Rn.
  [[nodiscard]] std::optional<double> named_value(std::uint32_t slot, ValueFault& fault) const;
  [[nodiscard]] bool is_set(std::uint32_t slot) const;
  [[nodiscard]] std::optional<double> predefined(std::uint32_t row, ValueFault& fault) const;
  [[nodiscard]] double r_parameter(std::uint32_t number) const { return r_parameters_[number]; }

  // False, with the reason, when the number cannot be set.
  [[nodiscard]] bool set_numbered(double number, double value, ValueFault& fault);
  void set_named(std::uint32_t slot, double value) { named_[slot] = value; }
  void set_r_parameter(std::uint32_t number, double value) { r_parameters_[number] = value; }
  // What is kept through power-off: #500 to #999, #3901 and #3902 of the Fanuc dialect; NaN:
  // vacant.
  [[nodiscard]] double kept_variable(int number) const;
  void set_kept_variable(int number, double value);
  // #5399, what M66 found.
  void set_input_result(double value);
  // #<_value>; nothing: the O-subprogram returned no value.
  void set_returned_value(std::optional<double> value) { returned_ = value; }

  // The local parameters with which a call of a text begins, all of them unset (vacant) or 0.
  [[nodiscard]] LocalParameters fresh_locals(const TextRules& rules) const;
  // From here on what is kept through power-off is written to be read again only, until the search
  // for a block ends.
  void begin_search() { searched_.emplace(); }
  void end_search() { searched_.reset(); }

  // Puts `locals` in force and returns those that were.
  LocalParameters exchange_locals(LocalParameters locals);

 private:
  [[nodiscard]] ParameterView view() const;
  [[nodiscard]] std::optional<double> predefined_value(const PredefinedParameter& row,
                                                       ValueFault& fault) const;
  void keep_globals();
  // What the Fanuc dialect has under a number; nullptr for others than #1 to #33 and #100 to #199.
  [[nodiscard]] double* variable_in_memory(double number);
  [[nodiscard]] bool find_kept_place(int& number, ValueFault& fault) const;
  [[nodiscard]] bool is_common_variable(int number) const;
  std::optional<double> macro_variable(int number, ValueFault& fault);
  bool set_macro_variable(int number, double value, ValueFault& fault);

  const BlockSurroundings& around_;
  const RunPlace& place_;
  std::shared_ptr<const Program> program_;  // whose names have the slots
  std::vector<double> numbered_;            // #1 ... #5602
  std::vector<double> named_;               // by slot; NaN: not set
  std::map<std::string, double> globals_;   // #<_name>, from run to run
  std::vector<double> r_parameters_;        // R0 ... R999
  std::vector<double> common_;              // #100 ... #199 of the Fanuc dialect, until power-off
  std::optional<double> returned_;
  std::optional<std::map<int, double>> searched_;  // #500 ... #999 as a search would write them
};

}  // namespace stanok::lang

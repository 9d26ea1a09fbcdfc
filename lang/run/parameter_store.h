// The RS274 parameters of a run: #n, #<name>, R, and the value that an O-subprogram returned.
//
// Owner: ProgramRun, on the thread of the preparation. Owns all values that programs set; numbers
// and names that show the state of the machine are read from what lies around the blocks.
// Invariants: global names (#<_name>) and R parameters last from run to run, all others begin new;
// a named value is NaN until it is set.
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

// #1 to #30 belong to a call of an O-line or G65.
inline constexpr std::size_t local_parameter_count = 30;

// RS274 parameters that belong to one call: #1 to #30 and #<name>.
struct LocalParameters {
  std::array<double, local_parameter_count> numbered{};
  std::vector<double> named;  // by slot; global ones are not used
};

// Where a run stands, for the parameters that show it.
class RunPlace {
 public:
  RunPlace() = default;
  RunPlace(const RunPlace&) = delete;
  RunPlace& operator=(const RunPlace&) = delete;
  virtual ~RunPlace() = default;

  [[nodiscard]] virtual Origin origin() const = 0;
  [[nodiscard]] virtual int call_level() const = 0;  // 0: main program
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
  [[nodiscard]] double predefined(std::uint32_t row) const;
  [[nodiscard]] double r_parameter(std::uint32_t number) const { return r_parameters_[number]; }

  // False, with the reason, when the number cannot be set.
  [[nodiscard]] bool set_numbered(double number, double value, ValueFault& fault);
  void set_named(std::uint32_t slot, double value) { named_[slot] = value; }
  void set_r_parameter(std::uint32_t number, double value) { r_parameters_[number] = value; }
  // #5399, what M66 found.
  void set_input_result(double value);
  // #<_value>; nothing: the O-subprogram returned no value.
  void set_returned_value(std::optional<double> value) { returned_ = value; }

  // The local parameters with which a call begins, all of them unset or 0.
  [[nodiscard]] LocalParameters fresh_locals() const;
  // Puts `locals` in force and returns those that were.
  LocalParameters exchange_locals(LocalParameters locals);

 private:
  [[nodiscard]] ParameterView view() const;
  void keep_globals();

  const BlockSurroundings& around_;
  const RunPlace& place_;
  std::shared_ptr<const Program> program_;  // whose names have the slots
  std::vector<double> numbered_;            // #1 ... #5602
  std::vector<double> named_;               // by slot; NaN: not set
  std::map<std::string, double> globals_;   // #<_name>, from run to run
  std::vector<double> r_parameters_;        // R0 ... R999
  std::optional<double> returned_;
};

}  // namespace stanok::lang

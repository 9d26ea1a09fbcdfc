// Values of the RS274 kind (#5, -#<depth>, [#1 * 2], SIN[30]) and parameter settings, computed
// straight from the text of a line: what lets blocks with such values be executed like those with
// plain numbers, without tree and code.
//
// The grammar is that of lang/tree/bracket_parser.cc. What is rare or wrong (comments inside
// brackets, EXISTS, syntax errors) is refused here and left to the parser, so that this reader has
// to explain no text, only computations without a result.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/contract/dialect.h"

namespace stanok::lang {

// Why a value could not be computed or stored.
struct ValueFault {
  std::string_view code;
  std::string message;
  std::string label;
};

// What #n and #<name> stand for while a line is read.
class Parameters {
 public:
  Parameters() = default;
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;
  virtual ~Parameters() = default;

  // The value of #number or #<name>; NaN while values are not known yet, nothing (and why, in
  // `fault`) for one that cannot be read. Names are folded.
  virtual std::optional<double> numbered(double number, ValueFault& fault) = 0;
  virtual std::optional<double> named(const std::string& name, ValueFault& fault) = 0;
  // False: all values are NaN because no program runs. Otherwise NaN is a vacant parameter.
  [[nodiscard]] virtual bool are_known() const { return true; }
  // Whether #number may be read and set while a line is read: not when the machine must be asked.
  // NaN: a number that is computed.
  [[nodiscard]] virtual bool is_at_hand(double) const { return true; }
  // Where a value for #<name> goes; nothing for a name that cannot be set.
  virtual std::optional<std::uint32_t> slot_to_set(const std::string& name) = 0;
};

// #n=... or #<name>=... in a line: takes effect when the whole line is read.
struct TextSetting {
  std::optional<std::uint32_t> slot;  // of #<name>; nothing: #number
  double number = 0.0;
  double value = 0.0;
  std::string_view text;  // of the target
};

class TextValues {
 public:
  // `parameters` must outlive this.
  explicit TextValues(Parameters& parameters) : parameters_(parameters) {}

  // Begins a line whose text is read up to `end`.
  void begin_line(const char* end, const TextRules& rules) {
    end_ = end;
    rules_ = rules;
    if (!settings_.empty()) settings_.clear();
    if (!fault_text_.empty()) fault_text_ = {};
  }
  // Reads the value at `at`, which is left behind it. Nothing when the text is refused or, with
  // faulty(), has no value.
  std::optional<double> read(const char*& at);
  // Reads the setting whose `#` stands at `at`; false as above.
  bool read_setting(const char*& at);

  [[nodiscard]] bool are_known() const { return parameters_.are_known(); }
  [[nodiscard]] const std::vector<TextSetting>& settings() const { return settings_; }
  // The text is right, but a computation in it has no result: why, and where.
  [[nodiscard]] bool faulty() const { return !fault_text_.empty(); }
  [[nodiscard]] const ValueFault& fault() const { return fault_; }
  [[nodiscard]] std::string_view fault_text() const { return fault_text_; }

 private:
  using MaybeValue = std::optional<double>;

  [[nodiscard]] char character(std::size_t ahead = 0) const {
    return static_cast<std::size_t>(end_ - at_) > ahead ? at_[ahead] : '\0';
  }
  void skip_blanks();
  // Letters, digits and _ from here.
  [[nodiscard]] std::string_view name_ahead() const;
  bool read_parameter_name();
  MaybeValue value();
  MaybeValue unsigned_value();
  MaybeValue number();
  MaybeValue parameter();
  MaybeValue bracket();
  MaybeValue binary(int level);
  MaybeValue function();
  MaybeValue fail(const char* first, ValueFault fault);

  Parameters& parameters_;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  TextRules rules_;
  int depth_ = 0;         // as TokenCursor::nesting_
  int operators_ = 0;     // of the current value
  bool in_word_ = false;  // the value is one of a word, not of a setting
  std::string name_;      // of the current parameter
  std::vector<TextSetting> settings_;
  ValueFault fault_;
  std::string_view fault_text_;
};

}  // namespace stanok::lang

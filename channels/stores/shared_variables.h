// Shared variables of the machine: one value for all channels, read and written in the cycle.
//
// Declared by preparations when they load a program; their cells are taken from stores of fixed
// capacity and stay until power-off. Values are read and written by the cycle only, in the order of
// channels; all are 0 or "" at the start.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/messages/item.h"
#include "lang/run/interpreter.h"

namespace stanok::channels {

class SharedVariables {
 public:
  static constexpr std::size_t number_cells = 65536;
  static constexpr std::size_t text_cells = 256;

  SharedVariables();

  // Preparations, any thread. The reason when it is declared differently already, or no cell is
  // left.
  [[nodiscard]] std::optional<Diagnostic> declare(const lang::SharedVariable& variable);
  // Where element `index` of a declared variable is kept.
  struct Cell {
    std::int32_t number = 0;
    bool is_text = false;
  };
  [[nodiscard]] Cell cell(const std::string& name, int index) const;

  // The cycle.
  [[nodiscard]] double number(std::int32_t cell) const RT_SAFE { return numbers_[cell]; }
  void set_number(std::int32_t cell, double value) RT_SAFE { numbers_[cell] = value; }
  [[nodiscard]] const ShortText& text(std::int32_t cell) const RT_SAFE { return texts_[cell]; }
  void set_text(std::int32_t cell, const ShortText& value) RT_SAFE { texts_[cell] = value; }
  // False, and nothing is changed, when it does not fit behind what is there.
  [[nodiscard]] bool append_text(std::int32_t cell, const ShortText& more) RT_SAFE {
    ShortText& text = texts_[cell];
    constexpr std::size_t characters_max = sizeof(ShortText{}.characters) - 1;
    if (text.view().size() + more.view().size() > characters_max) return false;
    text.append(more.view());
    return true;
  }

 private:
  struct Entry {
    lang::SharedVariable variable;
    std::size_t first_cell = 0;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::size_t numbers_used_ = 0;
  std::size_t texts_used_ = 0;
  NumberedList<double> numbers_;
  NumberedList<ShortText> texts_;
};

}  // namespace stanok::channels

#include "channels/stores/shared_variables.h"

namespace stanok::channels {
namespace {

bool same_declaration(const lang::SharedVariable& one, const lang::SharedVariable& other) {
  return one.is_text == other.is_text && one.is_bool == other.is_bool && one.rows == other.rows &&
         one.columns == other.columns && one.is_array == other.is_array;
}

}  // namespace

SharedVariables::SharedVariables() : numbers_(number_cells), texts_(text_cells) {}

std::optional<Diagnostic> SharedVariables::declare(const lang::SharedVariable& variable) {
  const std::lock_guard lock(mutex_);
  Diagnostic diagnostic;
  diagnostic.code = "E6026";
  diagnostic.place = variable.place;
  const auto known = entries_.find(variable.name);
  if (known != entries_.end()) {
    if (same_declaration(known->second.variable, variable)) return std::nullopt;
    diagnostic.message =
        "`shared " + variable.name + "` is declared with another type or size elsewhere";
    diagnostic.notes.push_back({"first declared here", known->second.variable.place});
    return diagnostic;
  }
  std::size_t& used = variable.is_text ? texts_used_ : numbers_used_;
  const std::size_t capacity = variable.is_text ? text_cells : number_cells;
  if (variable.elements() > capacity - used) {
    diagnostic.code = "E8002";
    diagnostic.message = "there is no room left for `shared " + variable.name + "`";
    return diagnostic;
  }
  entries_[variable.name] = {variable, used};
  used += variable.elements();
  return std::nullopt;
}

SharedVariables::Cell SharedVariables::cell(const std::string& name, int index) const {
  const std::lock_guard lock(mutex_);
  const Entry& entry = entries_.at(name);
  return {static_cast<std::int32_t>(entry.first_cell) + index, entry.variable.is_text};
}

}  // namespace stanok::channels

#include "jobs/tools/tool_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include "base/assert.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

// Calls `see` with the place of the key in the tool: double&, int& or std::string&.
template <class See>
void see_value(ToolEdge& tool, const ToolKey& key, const See& see) {
  std::visit(
      [&](auto slot) {
        using Member = std::remove_reference_t<decltype(slot(tool))>;
        if constexpr (std::is_same_v<Member, double> || std::is_same_v<Member, int> ||
                      std::is_same_v<Member, std::string>) {
          see(slot(tool));
        }
      },
      key.slot);
}

}  // namespace

const ToolKey& tool_key(std::string_view name) {
  const auto& keys = config::tool_keys();
  const auto found = std::ranges::find(keys, name, &ToolKey::name);
  STANOK_ASSERT(found != keys.end());
  return *found;
}

bool is_text(const ToolKey& key) {
  return std::holds_alternative<std::string& (*)(ToolEdge&)>(key.slot);
}

bool is_length(const ToolKey& key) {
  return key.unit == "mm";
}

bool set_number(ToolEdge& tool, const ToolKey& key, double value) {
  bool is_set = true;
  see_value(tool, key, [&](auto& member) {
    if constexpr (std::is_same_v<decltype(member), double&>) {
      member = value;
    } else if constexpr (std::is_same_v<decltype(member), int&>) {
      is_set = std::abs(value) <= std::numeric_limits<int>::max() && value == std::trunc(value);
      if (is_set) member = static_cast<int>(value);
    }
  });
  return is_set;
}

void set_text(ToolEdge& tool, const ToolKey& key, std::string text) {
  see_value(tool, key, [&](auto& member) {
    if constexpr (std::is_same_v<decltype(member), std::string&>) member = std::move(text);
  });
}

double number_of(const ToolEdge& tool, const ToolKey& key) {
  ToolEdge copy = tool;
  double value = 0.0;
  see_value(copy, key, [&](const auto& member) {
    if constexpr (!std::is_same_v<decltype(member), const std::string&>) {
      value = static_cast<double>(member);
    }
  });
  return value;
}

std::string text_of(const ToolEdge& tool, const ToolKey& key) {
  ToolEdge copy = tool;
  std::string text;
  see_value(copy, key, [&](const auto& member) {
    if constexpr (std::is_same_v<decltype(member), const std::string&>) {
      text = member;
    } else {
      text = config::number_text(static_cast<double>(member));
    }
  });
  return text;
}

std::string range_of(const ToolKey& key) {
  const bool has_max = std::isfinite(key.allowed.max);
  if (!std::isfinite(key.allowed.min)) return "a finite number";
  const std::string min = config::number_text(key.allowed.min);
  return has_max ? min + " to " + config::number_text(key.allowed.max) : min + " or more";
}

bool are_equal(const ToolEdge& a, const ToolEdge& b, const ToolKey& key) {
  constexpr double smallest_difference = 1e-9;
  if (is_text(key)) return text_of(a, key) == text_of(b, key);
  return std::abs(number_of(a, key) - number_of(b, key)) <= smallest_difference;
}

}  // namespace stanok::jobs

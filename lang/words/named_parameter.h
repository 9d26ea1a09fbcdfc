// The names of RS274 parameters in one program, #<name> and #<_name>: each has a slot.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace stanok::lang {

class NamedParameters {
 public:
  // The slot of a folded name; a new one is made for a name not seen before.
  std::uint32_t add(std::string_view name) {
    if (const auto known = find(name)) return *known;
    const auto slot = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    slots_.emplace(name, slot);
    return slot;
  }
  [[nodiscard]] std::optional<std::uint32_t> find(std::string_view name) const {
    const auto known = slots_.find(name);
    return known == slots_.end() ? std::nullopt : std::optional(known->second);
  }
  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const std::string& operator[](std::size_t slot) const { return names_[slot]; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
      return std::hash<std::string_view>()(name);
    }
  };
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> slots_;
};

}  // namespace stanok::lang

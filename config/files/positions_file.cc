#include "config/files/positions_file.h"

#include <sstream>

#include "config/text/key_table.h"

namespace stanok::config {

std::string to_positions_text(const channels::AxisRow& positions) {
  toml::table table;
  for (const auto& [axis, position] : positions) table.insert(axis, position);
  std::ostringstream text;
  text << toml::table{{"position", std::move(table)}} << "\n";
  return text.str();
}

channels::AxisRow read_positions_text(const std::string& text, const std::filesystem::path& file) {
  FaultList faults({{file, text}});
  channels::AxisRow positions;
  if (const auto root = parse_file(file, faults)) {
    const Scope scope{faults, "positions"};
    refuse_unknown_keys(*root, {"position"}, scope);
    const toml::table* table = (*root)["position"].as_table();
    if (table == nullptr) {
      scope.fault(root->source(), "there is no table [position]");
    } else {
      for (const auto& [axis, node] : *table)
        detail::read_value(node, {.name = axis.str(), .unit = "mm, deg", .meaning = "position"},
                           scope, positions[std::string(axis.str())]);
    }
  }
  faults.throw_if_any();
  return positions;
}

}  // namespace stanok::config

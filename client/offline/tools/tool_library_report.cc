#include "client/offline/tools/tool_library_report.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "base/diagnostic.h"
#include "client/terminal/diagnostic_output.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

std::string owner_text(int tool, int edge) {
  if (tool == 0) return "the file";
  return edge == 1 ? fmt::format("tool {}", tool) : fmt::format("tool {} edge {}", tool, edge);
}

std::string field_text(const jobs::NotCarried& lost) {
  return lost.value.empty() ? lost.field : fmt::format("{} {}", lost.field, lost.value);
}

}  // namespace

std::string to_text(std::span<const jobs::NotCarried> not_carried) {
  using Owner = std::pair<int, int>;
  // The fields of a tool, by the reason for which they are not carried.
  std::map<Owner, std::map<std::string, std::string>> fields;
  for (const jobs::NotCarried& lost : not_carried) {
    std::string& list = fields[{lost.tool, lost.edge}][lost.reason];
    list += (list.empty() ? "" : ", ") + field_text(lost);
  }
  std::string text;
  for (const auto& [owner, by_reason] : fields) {
    for (const auto& [reason, list] : by_reason) {
      text += fmt::format("{}: not carried: {} ({})\n", owner_text(owner.first, owner.second), list,
                          reason);
    }
  }
  return text;
}

ordered_json to_json(std::span<const jobs::NotCarried> not_carried) {
  auto list = ordered_json::array();
  for (const jobs::NotCarried& lost : not_carried) {
    list.push_back({{"tool", lost.tool},
                    {"edge", lost.edge},
                    {"field", lost.field},
                    {"value", lost.value},
                    {"reason", lost.reason}});
  }
  return list;
}

ordered_json refusal_json(const config::ConfigError& error) {
  auto list = ordered_json::array();
  for (const config::ConfigFault& fault : error.faults()) {
    Diagnostic diagnostic;
    diagnostic.code = "E9014";
    diagnostic.place.file = fault.file;
    diagnostic.place.line = diagnostic.place.end_line = static_cast<int>(fault.line);
    diagnostic.place.column = diagnostic.place.end_column = static_cast<int>(fault.column);
    diagnostic.message = fault.text;
    list.push_back(to_json(diagnostic));
  }
  return {{"ok", false}, {"diagnostics", std::move(list)}};
}

}  // namespace stanok::client

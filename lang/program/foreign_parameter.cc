#include "lang/program/foreign_parameter.h"

#include <map>

#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

struct Uses {
  std::uint16_t file = 0;
  Span span;  // of the first one
  bool is_read = false;
  bool is_set = false;
};

std::map<int, Uses> uses_of(const Program& program) {
  std::map<int, Uses> uses;
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    const auto file = static_cast<std::uint16_t>(i);
    for (const ParameterUse& use : program.files[i]->parameter_uses) {
      Uses& all = uses.try_emplace(use.number, Uses{file, use.span}).first->second;
      (use.access == ParameterAccess::set ? all.is_set : all.is_read) = true;
    }
  }
  return uses;
}

}  // namespace

std::vector<ForeignParameter> foreign_parameters(const Program& program) {
  std::vector<ForeignParameter> found;
  for (const auto& [number, uses] : uses_of(program)) {
    if (uses.is_read && uses.is_set) continue;
    const std::string name = "`#" + std::to_string(number) + "`";
    ForeignParameter parameter{uses.file, uses.span, {}, {}, {}};
    parameter.message =
        name + (uses.is_read
                    ? " is 0: in this dialect it is a variable of the program that nothing sets"
                    : " has no effect: in this dialect it is a variable of the program that "
                      "nothing reads");
    parameter.label = "on Fanuc controls: " + std::string(meaning_on_fanuc(number));
    if (is_position_on_fanuc(number)) {
      parameter.help.emplace_back(
          "`#<_x>` and `#<_abs_x>` are the positions in the workpiece and in the machine");
    }
    parameter.help.emplace_back(
        "for a program of a Fanuc control write `(dialect fanuc)` in its first line");
    found.push_back(std::move(parameter));
  }
  return found;
}

}  // namespace stanok::lang

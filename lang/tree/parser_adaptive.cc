// #adaptive: force control. `force`, `oscillate` and `off` take values, `vibration` says on or off
// before them.
#include <array>
#include <utility>

#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

using ForceKind = ForceControl::Kind;

struct AdaptiveForm {
  std::string_view name;
  ForceKind kind;
  std::size_t least;  // values
  std::size_t most;
  std::string_view example;
};

constexpr auto adaptive_forms = std::to_array<AdaptiveForm>({
    {"off", ForceKind::off, 0, 0, "`#adaptive (off)`"},
    {"force", ForceKind::force, 1, 3,
     "`#adaptive (force, P_z)` or `#adaptive (force, P_z, S_min, S_max)`"},
    {"oscillate", ForceKind::oscillate, 2, 2, "`#adaptive (oscillate, P_osc, f)`"},
    {"vibration", ForceKind::vibration_on, 0, 3,
     "`#adaptive (vibration, on)`, `#adaptive (vibration, on, level, m_d, f)` or "
     "`#adaptive (vibration, off)`"},
});

const AdaptiveForm* adaptive_form_called(std::string_view name) {
  for (const AdaptiveForm& form : adaptive_forms) {
    if (form.name == name) return &form;
  }
  return nullptr;
}

}  // namespace

Parser::MaybeStatement Parser::parse_adaptive(const Span& name) {
  line_ends_ = LineEnds::significant;
  if (!expect("(", "`#adaptive`")) return std::nullopt;
  const Token word = scanner_.take(line_ends_);
  const AdaptiveForm* const form =
      word.kind == TokenKind::name ? adaptive_form_called(folded(word.text)) : nullptr;
  if (form == nullptr) {
    report_unexpected(word, "`force`, `oscillate`, `vibration` or `off`");
    return std::nullopt;
  }
  AdaptiveDirective directive{form->kind, {}};
  if (form->kind == ForceKind::vibration_on && !parse_vibration_switch(directive))
    return std::nullopt;
  const bool good =
      accept(",") ? parse_list(")", directive.arguments) : expect(")", "the orders of `#adaptive`");
  if (!good || !finish_line()) return std::nullopt;
  const std::size_t given = directive.arguments.size();
  // The clamps come together, as do the values of the oscillation.
  const bool has_some = given == 2 && form->most == 3;
  const bool is_switched_off = directive.kind == ForceKind::vibration_off && given > 0;
  const bool has_one_of_three = given == 1 && form->kind == ForceKind::vibration_on;
  if (given < form->least || given > form->most || has_some || has_one_of_three ||
      is_switched_off) {
    reporter_
        .error("E3005", name, "`#adaptive` does not take these values", "wrong number of values")
        .help.push_back("write " + std::string(form->example));
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

bool Parser::parse_vibration_switch(AdaptiveDirective& directive) {
  if (!expect(",", "`vibration`")) return false;
  const Token word = scanner_.take(line_ends_);
  const std::string wanted = folded(word.text);
  if (word.kind != TokenKind::name || (wanted != "on" && wanted != "off")) {
    report_unexpected(word, "`on` or `off`");
    return false;
  }
  directive.kind = wanted == "on" ? ForceKind::vibration_on : ForceKind::vibration_off;
  return true;
}

}  // namespace stanok::lang

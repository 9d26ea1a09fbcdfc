#include "channels/contract/operator_command.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/enum_names.h"

namespace stanok::channels {
namespace {

constexpr auto law_names = enum_names<AutomaticLaw>(
    {{AutomaticLaw::modulated, "modulated"}, {AutomaticLaw::linear, "linear"}});
constexpr auto quantity_names =
    enum_names<ForceQuantity>({{ForceQuantity::not_named, ""},
                               {ForceQuantity::force, "force"},
                               {ForceQuantity::level, "level"},
                               {ForceQuantity::mass, "mass"},
                               {ForceQuantity::frequency, "frequency"}});

// A small number that a field for real ones carries.
std::int32_t whole(double value) {
  constexpr double whole_max = 1e9;
  return value > 0.0 ? static_cast<std::int32_t>(std::min(value, whole_max)) : 0;
}

// From the members of a command to the fields, or back: a Form has one function for each field.
class ToFields {
 public:
  explicit ToFields(CommandFields& fields) : fields_(fields) {}

  void text(const ShortText& member) { fields_.text = member; }
  template <class Enum, std::size_t count>
  void text(Enum member, const EnumNames<Enum, count>& names) {
    fields_.text = names[member];
  }
  void number(std::int32_t member) { fields_.number = member; }
  template <class Enum>
  void choice(Enum member, Enum /*last*/) {
    fields_.number = static_cast<std::int32_t>(member);
  }
  void on_or_off(Switch member) { fields_.number = member == Switch::on ? 1 : 0; }
  void value(double member) { fields_.value = member; }
  void value_2(double member) { fields_.value_2 = member; }

 private:
  CommandFields& fields_;
};

class FromFields {
 public:
  explicit FromFields(const CommandFields& fields) : fields_(fields) {}

  void text(ShortText& member) { member = fields_.text; }
  template <class Enum, std::size_t count>
  void text(Enum& member, const EnumNames<Enum, count>& names) {
    const auto named = names.value(fields_.text.view());
    is_known_ = is_known_ && named.has_value();
    member = named.value_or(member);
  }
  void number(std::int32_t& member) { member = fields_.number; }
  template <class Enum>
  void choice(Enum& member, Enum last) {
    is_known_ = is_known_ && fields_.number >= 0 && fields_.number <= static_cast<int>(last);
    if (is_known_) member = static_cast<Enum>(fields_.number);
  }
  void on_or_off(Switch& member) { member = fields_.number != 0 ? Switch::on : Switch::off; }
  void value(double& member) { member = fields_.value; }
  void value(std::int32_t& member) { member = whole(fields_.value); }
  void value_2(double& member) { member = fields_.value_2; }
  void value_2(std::int32_t& member) { member = whole(fields_.value_2); }

  // Whether all fields had a meaning.
  [[nodiscard]] bool is_known() const { return is_known_; }

 private:
  const CommandFields& fields_;
  bool is_known_ = true;
};

// Which field each member of a command is in: one overload for each command.
template <class Command>
  requires std::is_empty_v<Command>
void convert(auto& /*form*/, Command& /*command*/) {}
void convert(auto& form, commands::ProgramLoad& command) {
  form.text(command.program);
}
void convert(auto& form, commands::ProgramRun& command) {
  form.text(command.program);
}
void convert(auto& form, commands::OverrideFeed& command) {
  form.value(command.factor);
}
void convert(auto& form, commands::OverrideRapid& command) {
  form.value(command.factor);
}
void convert(auto& form, commands::OverrideSpindle& command) {
  form.value(command.factor);
}
void convert(auto& form, commands::KinematicsSelect& command) {
  form.number(command.scheme);
}
void convert(auto& form, commands::OptionalStop& command) {
  form.on_or_off(command.to);
}
void convert(auto& form, commands::BlockSkip& command) {
  form.number(command.level);
}
void convert(auto& form, commands::BlockSkipOff& command) {
  form.number(command.level);
}
void convert(auto& form, commands::SingleBlock& command) {
  form.on_or_off(command.to);
}
void convert(auto& form, commands::Mdi& command) {
  form.text(command.line);
}
void convert(auto& form, commands::ProcessInterrupt& command) {
  form.value(command.stand_mm);
  form.value_2(command.cut_mm);
}
void convert(auto& form, commands::ProcessAutomatic& command) {
  form.text(command.law, law_names);
  form.on_or_off(command.to);
}
void convert(auto& form, commands::Jog& command) {
  form.text(command.axis);
  form.choice(command.frame, JogFrame::plane);
  form.value(command.velocity);
  form.value_2(command.increment);
}
void convert(auto& form, commands::Home& command) {
  form.text(command.axis);
}
void convert(auto& form, commands::ToolSet& command) {
  form.number(command.tool);
  form.text(command.key);
  form.value(command.value);
  form.value_2(command.edge);
}
void convert(auto& form, commands::OffsetSet& command) {
  form.text(command.place);
  form.value(command.value);
}
void convert(auto& form, commands::ProcessAdaptive& command) {
  form.choice(command.action, ForceAction::set);
  form.text(command.quantity, quantity_names);
  form.value(command.value);
}
void convert(auto& form, commands::ProgramSearch& command) {
  form.text(command.target);
  form.choice(command.way, SearchWay::not_calculated);
  form.value(command.passes);
}
void convert(auto& form, commands::ChannelControl& command) {
  form.number(command.session);
}
void convert(auto& form, commands::OffsetTouch& command) {
  form.text(command.place);
  form.value(command.point_W);
  form.number(command.active);
}
void convert(auto& form, commands::ProgramReturn& command) {
  form.value(command.velocity);
}
void convert(auto& form, commands::SpindleSwitch& command) {
  form.on_or_off(command.to);
}
void convert(auto& form, commands::CoolantSwitch& command) {
  form.on_or_off(command.to);
}
void convert(auto& form, commands::ProgramRetrace& command) {
  form.choice(command.direction, RetraceDirection::forward);
  form.value(command.length);
}
void convert(auto& form, commands::FirstPart& command) {
  form.on_or_off(command.to);
}
void convert(auto& form, commands::Handwheel& command) {
  form.text(command.axis);
  form.value(command.way);
}
void convert(auto& form, commands::ToolTouch& command) {
  form.text(command.key);
  form.value(command.point_W);
  form.number(command.tool);
  form.value_2(command.edge);
}

using MadeCommand = std::optional<OperatorCommand>;

template <std::size_t action>
MadeCommand made(const CommandFields& fields) {
  std::variant_alternative_t<action, OperatorCommand> command;
  FromFields form(fields);
  convert(form, command);
  return form.is_known() ? MadeCommand(command) : std::nullopt;
}

constexpr std::size_t action_count = std::variant_size_v<OperatorCommand>;

// A function for each action, in their order.
constexpr auto makers = []<std::size_t... action>(std::index_sequence<action...>) {
  return std::array<MadeCommand (*)(const CommandFields&), action_count>{&made<action>...};
}(std::make_index_sequence<action_count>());

}  // namespace

CommandFields fields_of(const OperatorCommand& command) {
  CommandFields fields;
  fields.action = action_of(command);
  ToFields form(fields);
  std::visit([&](auto copy) { convert(form, copy); }, command);
  return fields;
}

std::optional<OperatorCommand> command_of(const CommandFields& fields) {
  const auto action = place_of(fields.action);
  return action < action_count ? makers[action](fields) : std::nullopt;
}

}  // namespace stanok::channels

// The operator's command table: every method once, with its parameters, the role it needs and one
// line of help.
//
// JSON-RPC dispatch, `rpc.discover`, the subcommands of `stanok`, shell completion and the list in
// docs/reference/protocol.md are all made from these rows. A method is called `noun.verb`; a noun
// without verbs is its own method.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace stanok::protocol {

// What a session may do; each role includes the ones before it.
enum class Role : std::uint8_t { observer, machine_operator, integrator };

enum class ParameterType : std::uint8_t { integer, number, text, choice, text_list };
enum class Presence : std::uint8_t { optional, required };
// Where the parameter stands on the command line of `stanok`.
// A file is named there, "-" is the standard input, and its text is the parameter's value.
enum class Spelling : std::uint8_t { option, positional, file };
// Which field of a MachineRequest the parameter fills (protocol/machine_request.h).
// A choice that carries a number is its place among the choices, from 0.
enum class Carries : std::uint8_t {
  nothing,
  channel,
  number,
  fraction_of_percent,
  value,
  value_2,
  text,
  more_text,  // behind the text, after a blank
};

struct Parameter {
  std::string_view name;
  ParameterType type = ParameterType::text;
  Presence presence = Presence::optional;
  Spelling spelling = Spelling::option;
  Carries carries = Carries::nothing;
  std::string_view unit{};
  // Value of a number; length in bytes of a text; members of a list.
  double minimum = 0.0;
  double maximum = std::numeric_limits<double>::max();
  std::span<const std::string_view> choices{};
  std::string_view help{};
};

struct Method {
  std::string_view name;
  Role role = Role::observer;
  std::string_view help{};
  std::span<const Parameter> parameters{};
  // Name of the channels::OperatorAction that the method hands to the real-time cycle; empty: the
  // daemon answers itself.
  std::string_view action{};
};

// In the order of the documentation; methods of a noun stand together.
[[nodiscard]] std::span<const Method> methods();

// The row of a method, or nullptr.
[[nodiscard]] const Method* find_method(std::string_view name);

// "program" of "program.load"; the whole name when there is no verb.
[[nodiscard]] std::string_view noun(const Method& method);
// "load" of "program.load"; empty when there is no verb.
[[nodiscard]] std::string_view verb(const Method& method);
// One line about a noun, for help texts.
[[nodiscard]] std::string_view noun_help(std::string_view noun);

[[nodiscard]] std::string_view role_name(Role role);
[[nodiscard]] std::string_view type_name(ParameterType type);

}  // namespace stanok::protocol

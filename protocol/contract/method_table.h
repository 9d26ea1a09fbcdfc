// The operator's command table: one row for every method, with all that there is to say about it.
//
// JSON-RPC dispatch, the check of roles, `rpc.discover` with its schemas, the subcommands of
// `stanok`, shell completion, manual pages and the list in docs/reference/protocol.md are all made
// from these rows, which are in methods_of_*.cc
// (docs/developer/how-to-add.md). A method is called `noun.verb`; a noun
// without verbs is its own method.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace stanok::protocol {

// What a session may do; each role includes the ones before it.
enum class Role : std::uint8_t { observer, machine_operator, programmer, integrator };

enum class ParameterType : std::uint8_t { integer, number, text, choice, text_list };
enum class Presence : std::uint8_t { optional, required };
// Where the parameter stands on the command line of `stanok`.
// A file is named there, "-" is the standard input, and its text is the parameter's value; a flag
// is an option without a value, which stands for 1.
enum class Spelling : std::uint8_t { option, positional, file, flag };
// Which field of a MachineRequest the parameter fills (protocol/contract/machine_request.h).
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
  std::string_view usual{};  // choice that `stanok` gives when the command line says nothing
  std::string_view help{};
};

// What a method does to the machine.
enum class Effect : std::uint8_t {
  looks,          // nothing: the right of observers
  changes,        // sets something; by itself it moves no axis
  begins_motion,  // something may begin to move, or get power
  stops,          // only ever brings motion to rest: taken at once, whatever else goes on
};

// How long a method takes, and with it the command of `stanok`.
enum class Course : std::uint8_t {
  prompt,         // answered at once
  reads_program,  // answered when a program has been read, as long as that may be
  moves_axes,     // answered when axes have come to where they go
  reports,        // notifications follow the answer
  holds,          // what it takes is held as long as the connection lasts, unless `on` is 0
  repeats,        // to be asked again and again, unless an increment is given
};

// Which channels the command of `stanok` can be given for.
enum class Reach : std::uint8_t { one_channel, every_channel };  // every: with --all

// Everything about a method.
struct Method {
  std::string_view name;
  Role role = Role::observer;
  Effect effect = Effect::looks;
  Course course = Course::prompt;
  Reach reach = Reach::one_channel;
  // Name of the channels::OperatorAction that the method hands to the real-time cycle, whose rules
  // say when it is admitted (channels/contract/command_rules.h); empty: the daemon answers itself.
  std::string_view action{};
  std::span<const Parameter> parameters{};
  std::string_view help{};
  std::string_view result =
      R"({"accepted":"boolean"})";  // its shape: protocol/contract/result_shapes.h
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
[[nodiscard]] std::string_view effect_name(Effect effect);
[[nodiscard]] std::optional<Role> role_named(std::string_view name);
[[nodiscard]] std::string_view type_name(ParameterType type);

}  // namespace stanok::protocol

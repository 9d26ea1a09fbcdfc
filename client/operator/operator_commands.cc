#include "client/operator/operator_commands.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <system_error>

#include "base/system_error.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/screen_text.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using protocol::Method;
using protocol::Parameter;
using protocol::ParameterType;

constexpr double whole_number_max = 1e9;

// What the command line says of one verb, before it is understood.
struct GivenOptions {
  std::map<std::string, std::vector<std::string>> values;  // by parameter
  bool wait = false;
  bool every_channel = false;
  bool json = false;
  std::string socket;
  double timeout_s = 0.0;
};

// rate_hz -> --rate-hz
std::string option_name(const Parameter& parameter) {
  std::string name = "--" + std::string(parameter.name);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string help_text(const Parameter& parameter) {
  std::string text(parameter.help);
  if (!parameter.unit.empty()) text += " [" + std::string(parameter.unit) + "]";
  for (std::size_t k = 0; k < parameter.choices.size(); ++k)
    text += (k == 0 ? "; values: " : ", ") + std::string(parameter.choices[k]);
  return text;
}

// What the help shows for a value.
const char* type_text(const Parameter& parameter) {
  if (parameter.spelling == protocol::Spelling::file) return "FILE";
  switch (parameter.type) {
    case ParameterType::integer:
      return "N";
    case ParameterType::number:
      return "NUMBER";
    case ParameterType::choice:
    case ParameterType::text_list:
      return "WORD";
    case ParameterType::text:
      break;
  }
  return "TEXT";
}

json number(const Parameter& parameter, const std::string& text) {
  double value = 0.0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last) {
    throw CLI::ValidationError(std::string(parameter.name), "'" + text + "' is not a number");
  }
  const bool is_whole = std::abs(value) <= whole_number_max && value == std::floor(value);
  return is_whole ? json(static_cast<std::int64_t>(value)) : json(value);
}

// A file as text. "-": the standard input.
std::string text_of_parameter(const Parameter& parameter, const std::string& file) {
  std::ostringstream text;
  if (file == "-") {
    text << std::cin.rdbuf();
  } else {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !(text << stream.rdbuf())) {
      throw CLI::ValidationError(
          in_capitals(parameter.name),
          "'" + file + "' cannot be read" +
              (errno == 0 ? std::string(", or is empty") : ": " + system_error_text(errno)));
    }
  }
  return text.str();
}

json value_of(const Parameter& parameter, const std::vector<std::string>& words) {
  switch (parameter.type) {
    case ParameterType::integer:
    case ParameterType::number:
      return number(parameter, words.front());
    case ParameterType::text:
    case ParameterType::choice:
      return words.front();
    case ParameterType::text_list:
      return words;
  }
  return nullptr;
}

bool is_wait(const Parameter& parameter) {
  return parameter.name == "wait";
}

OperatorCall call_of(const Method& method, const GivenOptions& given) {
  OperatorCall call;
  call.method = &method;
  call.socket = given.socket;
  call.timeout_s = given.timeout_s;
  if (given.every_channel) call.called_for = CalledFor::every_channel;
  call.form = given.json ? OutputForm::json : OutputForm::people;
  for (const Parameter& parameter : method.parameters) {
    const auto words = given.values.find(std::string(parameter.name));
    if (words == given.values.end() || words->second.empty()) continue;
    if (parameter.spelling == protocol::Spelling::file) {
      call.parameters[words->first] = text_of_parameter(parameter, words->second.front());
      call.parameters.emplace("file", words->second.front());
    } else {
      call.parameters[words->first] = value_of(parameter, words->second);
    }
  }
  if (given.wait) call.parameters["wait"] = "done";
  if (const auto checked = protocol::checked_parameters(method, call.parameters); !checked) {
    throw CLI::ValidationError(checked.error().message);
  }
  return call;
}

void add_parameter(CLI::App& command, const Parameter& parameter, GivenOptions& given) {
  if (is_wait(parameter)) {
    given.wait = parameter.usual == "done";
    command.add_flag("--wait,!--no-wait", given.wait,
                     given.wait
                         ? "wait until the work is done; --no-wait: only until it is accepted"
                         : "wait until the work is done");
    return;
  }
  if (parameter.spelling == protocol::Spelling::flag) {
    auto& words = given.values[std::string(parameter.name)];
    command.add_flag_callback(
        option_name(parameter), [&words] { words = {"1"}; }, help_text(parameter));
    return;
  }
  const bool is_option = parameter.spelling == protocol::Spelling::option;
  const std::string name = is_option ? option_name(parameter) : in_capitals(parameter.name);
  auto* option =
      command.add_option(name, given.values[std::string(parameter.name)], help_text(parameter))
          ->type_name(type_text(parameter));
  if (parameter.type != ParameterType::text_list) option->expected(1)->allow_extra_args(false);
  if (parameter.presence == protocol::Presence::required) option->required();
}

void add_common_options(CLI::App& command, GivenOptions& given) {
  command.add_flag("--json", given.json, "print JSON");
  command.add_option("--socket", given.socket, "socket of the daemon")->type_name("PATH");
  command.add_option("--timeout", given.timeout_s, "give up after this time [s]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("SECONDS");
}

void add_method(CLI::App& app, const Method& method,
                const std::function<void(const OperatorCall&)>& on_call) {
  const std::string verb(protocol::verb(method));
  const std::string noun(protocol::noun(method));
  CLI::App& parent =
      verb.empty() ? app : noun_command(app, noun, std::string(protocol::noun_help(noun)));
  CLI::App* command = parent.add_subcommand(verb.empty() ? noun : verb, std::string(method.help));
  const auto given = std::make_shared<GivenOptions>();
  for (const Parameter& parameter : method.parameters) add_parameter(*command, parameter, *given);
  if (method.reach == protocol::Reach::every_channel)
    command->add_flag("--all", given->every_channel, "apply to every channel of the machine")
        ->excludes("--channel");
  add_common_options(*command, *given);
  command->callback([&method, given, on_call] { on_call(call_of(method, *given)); });
}

// All channels and what happens, drawn in place: a subscription in another form.
void add_watch(CLI::App& app, const std::function<void(const OperatorCall&)>& on_call) {
  CLI::App* command = app.add_subcommand(
      "watch", "show all channels as they change: state, block, position, alarms");
  const auto given = std::make_shared<GivenOptions>();
  add_common_options(*command, *given);
  command->callback([given, on_call] {
    const Method& method = *protocol::find_method("subscribe");
    given->values["topics"] = {"channels", "events"};
    OperatorCall call = call_of(method, *given);
    call.view = OperatorView::overview;
    on_call(call);
  });
}

void add_status(CLI::App& app, const std::function<void(const OperatorCall&)>& on_call) {
  CLI::App* command = app.add_subcommand(
      "status", "show the machine and all channels: program, codes, feed, spindles, tool, axes");
  const auto given = std::make_shared<GivenOptions>();
  add_common_options(*command, *given);
  command->callback([given, on_call] {
    OperatorCall call = call_of(*protocol::find_method("machine.status"), *given);
    call.view = OperatorView::status;
    on_call(call);
  });
}

}  // namespace

void add_operator_commands(CLI::App& app, const std::function<void(const OperatorCall&)>& on_call) {
  for (const Method& method : protocol::methods()) add_method(app, method, on_call);
  add_watch(app, on_call);
  add_status(app, on_call);
}

}  // namespace stanok::client

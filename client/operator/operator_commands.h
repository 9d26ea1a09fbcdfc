// The operator's subcommands of `stanok`, made from the command table
// (protocol/contract/method_table.h).
//
// `program.run` becomes `stanok program run PROGRAM --channel N --wait`: required parameters are
// positional, the others options; every verb has --json, --socket and --timeout.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "protocol/contract/method_table.h"

namespace stanok::client {

enum class OutputForm { people, json };

// What is shown of a machine: the answer as it is; `stanok watch`: the channels on a few lines;
// `stanok status`: the machine and all channels, once.
enum class OperatorView { answer, overview, status };
// `--all`: once for each channel of the machine.
enum class CalledFor { one_channel, every_channel };

// One operator command as given on the command line.
struct OperatorCall {
  const protocol::Method* method = nullptr;
  nlohmann::json parameters = nlohmann::json::object();
  std::string socket;      // empty: chosen by choose_socket
  double timeout_s = 0.0;  // 0: the usual time of the method
  OutputForm form = OutputForm::people;
  OperatorView view = OperatorView::answer;
  CalledFor called_for = CalledFor::one_channel;
};

// `on_call` is called while the command line is parsed, with checked parameters. A value that does
// not fit its parameter ends parsing with CLI::ValidationError.
void add_operator_commands(CLI::App& app, const std::function<void(const OperatorCall&)>& on_call);

}  // namespace stanok::client

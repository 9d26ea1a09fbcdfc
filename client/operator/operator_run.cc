#include "client/operator/operator_run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "base/catalogue.h"
#include "client/operator/channel_text.h"
#include "client/operator/confirmation.h"
#include "client/operator/operator_client.h"
#include "client/operator/result_text.h"
#include "client/operator/run_progress.h"
#include "client/operator/watch_view.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/output.h"
#include "protocol/contract/failure.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using protocol::Course;
using protocol::Failure;

constexpr double usual_timeout_s = 30.0;
constexpr auto stop_answered_within = std::chrono::seconds(1);

bool waits_for_the_end(const OperatorCall& call) {
  return call.parameters.value("wait", "") == "done";
}

bool is_stop(const OperatorCall& call) {
  return call.method->effect == protocol::Effect::stops;
}

bool is_watching(const OperatorCall& call) {
  return call.method->course == Course::reports;
}

// Compiling a program takes as long as the program is long; a run as long as it runs.
bool takes_its_time(const OperatorCall& call) {
  const Course course = call.method->course;
  return waits_for_the_end(call) || course == Course::reports || course == Course::reads_program ||
         course == Course::moves_axes;
}

OperatorClient::Deadline deadline_of(const OperatorCall& call) {
  const bool is_long = takes_its_time(call);
  const double seconds = call.timeout_s > 0.0 ? call.timeout_s : (is_long ? 0.0 : usual_timeout_s);
  if (seconds <= 0.0) return std::nullopt;
  return OperatorClient::Clock::now() + std::chrono::duration_cast<OperatorClient::Clock::duration>(
                                            std::chrono::duration<double>(seconds));
}

std::string place_text(const Place& place) {
  if (place.line == 0) return place.file.empty() ? "" : place.file + ": ";
  return place.file + ":" + std::to_string(place.line) +
         (place.column > 0 ? ":" + std::to_string(place.column) : "") + ": ";
}

void show_failure(const Failure& failure, OutputForm form) {
  if (form == OutputForm::json) write_json(json{{"error", to_json(failure)}});
  const Terminal terminal(STDERR_FILENO);
  const std::string code = failure.code.empty() ? "" : "[" + failure.code + "]";
  write_message(place_text(failure.place) + terminal.coloured("error" + code, Colour::red) + ": " +
                failure.message + "\n");
  const CatalogueRow* row = find_in_catalogue(failure.code);
  if (row != nullptr && !row->remedy.empty()) {
    write_message("  remedy: " + std::string(row->remedy) + "\n");
  }
}

void show_result(const OperatorCall& call, const json& result) {
  if (call.form == OutputForm::json && call.method->name == "channel.status") {
    write_json(in_machine_order(result));
  } else if (call.form == OutputForm::json) {
    write_json(result);
  } else {
    write_data(result_text(call.method->name, result, Terminal(STDOUT_FILENO)));
  }
}

int watch(OperatorClient& client, const OperatorCall& call, OperatorClient::Deadline deadline) {
  WatchView view(call.form, Terminal(STDOUT_FILENO), call.view);
  client.on_notification([&](const std::string& method, const json& parameters) {
    const std::string text = view.shown(method, parameters);
    return call.form == OutputForm::json ? write_data_now(text) : write_data_with_orders(text);
  });
  const auto accepted = client.call(std::string(call.method->name), call.parameters, deadline);
  if (!accepted) {
    show_failure(accepted.error(), call.form);
    return exit_code(accepted.error().kind);
  }
  client.listen(deadline);
  return exit_code(protocol::FailureKind::timed_out);
}

// The machine and every channel, once.
int tell_status(OperatorClient& client, const OperatorCall& call,
                OperatorClient::Deadline deadline) {
  const auto machine = client.call("machine.status", json::object(), deadline);
  if (!machine) {
    show_failure(machine.error(), call.form);
    return exit_code(machine.error().kind);
  }
  nlohmann::ordered_json all{{"machine", *machine}, {"channels", json::array()}};
  const Terminal terminal(STDOUT_FILENO);
  std::string text =
      machine->value("name", "") + ": " + (machine->value("on", false) ? "on" : "off") +
      ", drives " + machine->value("drives", "") + ", cycle " +
      cell_text(machine->value("cycle_us", json())) + " us, overruns " +
      cell_text(machine->value("rt", json::object()).value("overruns", json())) + "\n";
  for (const json& one : machine->value("channels", json::array())) {
    const auto status = client.call("channel.status", {{"channel", one.value("id", 0)}}, deadline);
    if (!status) {
      show_failure(status.error(), call.form);
      return exit_code(status.error().kind);
    }
    all["channels"].push_back(in_machine_order(*status));
    text += "\n" + channel_text(*status, terminal);
  }
  if (call.form == OutputForm::json) {
    write_json(all);
  } else {
    write_data(text);
  }
  return 0;
}

// A channel that was taken is held as long as this command lasts.
bool holds_channel(const OperatorCall& call) {
  return call.method->course == Course::holds && call.parameters.value("on", 1.0) != 0.0;
}

bool is_leased(const OperatorCall& call) {
  return call.method->course == Course::repeats && call.parameters.value("increment", 0.0) == 0.0;
}

// Every channel is asked, whatever another one answered; the exit code is that of the first
// refusal.
int call_for_all(OperatorClient& client, const OperatorCall& call,
                 OperatorClient::Deadline deadline) {
  int code = 0;
  json results = json::array();
  for (const json& channel : client.hello().value("channels", json::array())) {
    json parameters = call.parameters;
    parameters["channel"] = channel.value("id", 0);
    const auto result = client.call(std::string(call.method->name), parameters, deadline);
    if (result) {
      results.push_back({{"channel", parameters["channel"]}, {"result", *result}});
      continue;
    }
    results.push_back({{"channel", parameters["channel"]}, {"error", to_json(result.error())}});
    if (call.form == OutputForm::people) {
      write_message("channel " + cell_text(parameters["channel"]) + ": ");
      show_failure(result.error(), call.form);
    }
    if (code == 0) code = exit_code(result.error().kind);
  }
  if (call.form == OutputForm::json) write_json(results);
  return code;
}

// A continuous jog lasts as long as this command: to its time, until it is interrupted, or, along a
// path, to its end. Whatever ends it, the axis comes to rest when the lease has run out.
int keep_jogging(OperatorClient& client, const OperatorCall& call,
                 OperatorClient::Deadline deadline) {
  constexpr auto renewal = std::chrono::milliseconds(80);
  for (bool moves = false; !deadline || OperatorClient::Clock::now() < *deadline; moves = true) {
    const auto accepted = client.call(std::string(call.method->name), call.parameters,
                                      OperatorClient::Clock::now() + std::chrono::seconds(2));
    if (!accepted) {
      if (moves && accepted.error().code == "E6102") {
        write_message("the axes are at the end of the way\n");
        return 0;
      }
      show_failure(accepted.error(), call.form);
      return exit_code(accepted.error().kind);
    }
    client.listen(OperatorClient::Clock::now() + renewal);
  }
  return 0;
}

// What begins motion says how old it is, unless the command line does: it is refused where it comes
// late.
OperatorCall with_its_age(OperatorCall call, const json& hello) {
  const bool has_age = std::ranges::any_of(
      call.method->parameters, [](const auto& one) { return one.name == "seen_cycle"; });
  if (has_age && !call.parameters.contains("seen_cycle") && hello.contains("cycle"))
    call.parameters["seen_cycle"] = hello["cycle"];
  return call;
}

// What the daemon thinks unlikely is asked of people, and given again.
Expected<json, Failure> answer_to(OperatorClient& client, const OperatorCall& call,
                                  OperatorClient::Deadline deadline) {
  const std::string method(call.method->name);
  auto result = client.call(method, call.parameters, deadline);
  if (result || !wants_confirmation(call, result.error())) return result;
  if (!is_confirmed(call, result.error())) return result;
  json parameters = call.parameters;
  parameters["confirmed"] = 1;
  return client.call(method, parameters, deadline_of(call));
}

void show_refusal(const OperatorCall& call, const Failure& failure) {
  show_failure(failure, call.form);
  if (wants_confirmation(call, failure)) write_message("  to confirm it: --confirmed 1\n");
}

// Whatever the daemon is busy with. Where no answer comes, people are told soon, and it is waited
// on.
int stop(const OperatorCall& call) {
  OperatorClient client(choose_socket(call.socket), ClientPurpose::stop);
  const std::string method(call.method->name);
  const auto deadline = deadline_of(call);
  const auto soon = OperatorClient::Clock::now() + stop_answered_within;
  auto result = client.call(method, call.parameters, soon);
  if (!result && result.error().code == "E9016") {
    write_message(
        method +
        " was sent and is not answered: do not wait for it, use the emergency stop of the "
        "machine\n");
    result = client.wait_on(method, deadline);
  }
  if (!result) {
    show_failure(result.error(), call.form);
    return exit_code(result.error().kind);
  }
  show_result(call, *result);
  return result_exit_code(*result);
}

}  // namespace

int run_operator_call(const OperatorCall& given) {
  catch_interrupts();
  if (is_stop(given) && given.called_for != CalledFor::every_channel) return stop(given);
  OperatorClient client(choose_socket(given.socket));
  const OperatorCall call = with_its_age(given, client.hello());
  const auto deadline = deadline_of(call);
  if (call.view != OperatorView::status && is_watching(call)) return watch(client, call, deadline);
  if (call.view == OperatorView::status) return tell_status(client, call, deadline);
  if (call.called_for == CalledFor::every_channel) return call_for_all(client, call, deadline);
  if (is_leased(call)) {
    const bool has_end = call.timeout_s > 0.0;
    return keep_jogging(client, call, has_end ? deadline : std::nullopt);
  }
  const Terminal terminal(STDERR_FILENO);
  RunProgress progress(call.parameters.value("channel", 0.0), client.hello());
  const bool is_followed = waits_for_the_end(call) || call.method->course == Course::moves_axes;
  if (is_followed && terminal.is_terminal()) progress.follow(client);
  const auto result = answer_to(client, call, deadline);
  progress.clear();
  if (!result) {
    show_refusal(call, result.error());
    return exit_code(result.error().kind);
  }
  show_result(call, *result);
  if (holds_channel(call)) {
    std::fflush(stdout);
    client.listen(call.timeout_s > 0.0 ? deadline : std::nullopt);
  }
  return result_exit_code(*result);
}

}  // namespace stanok::client

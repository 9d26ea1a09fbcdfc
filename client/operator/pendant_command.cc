#include "client/operator/pendant_command.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "base/file_descriptor.h"
#include "base/system_error.h"
#include "client/operator/operator_client.h"
#include "client/operator/pendant.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/output.h"

namespace stanok::client {
namespace {

using nlohmann::json;

struct PendantOptions {
  std::string socket;
  std::string device;
  std::string axis;
  double step = 0.01;
  std::vector<std::string> key_texts;
  std::map<int, pendant::KeyEffect> keys{};
  int channel = 0;
  bool shows = false;
};

// Whole events, as they come from a device or a pipe.
class EventReader {
 public:
  explicit EventReader(const std::string& device)
      : device_(::open(device.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (device_.number() < 0)
      throw std::runtime_error("cannot open " + device + ": " + system_error_text(errno));
  }

  // Empty after a moment without any, and when the wait was interrupted; nothing: the device is
  // gone.
  [[nodiscard]] std::optional<std::vector<input_event>> next() {
    constexpr int moment_ms = 200;
    pollfd wanted{.fd = device_.number(), .events = POLLIN, .revents = 0};
    if (::poll(&wanted, 1, moment_ms) <= 0) return std::vector<input_event>{};
    std::array<char, 64 * sizeof(input_event)> bytes{};
    const ssize_t count = ::read(device_.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) return std::vector<input_event>{};
    if (count <= 0) return std::nullopt;
    bytes_.append(bytes.data(), static_cast<std::size_t>(count));
    return taken();
  }

 private:
  std::vector<input_event> taken() {
    std::vector<input_event> events(bytes_.size() / sizeof(input_event));
    const std::size_t whole = events.size() * sizeof(input_event);
    if (whole > 0) std::memcpy(events.data(), bytes_.data(), whole);
    bytes_.erase(0, whole);
    return events;
  }

  FileDescriptor device_;
  std::string bytes_;  // of an event that has not come whole yet
};

std::map<int, pendant::KeyEffect> keys_of(const std::vector<std::string>& texts) {
  std::map<int, pendant::KeyEffect> keys;
  for (const std::string& text : texts) {
    const std::size_t mark = text.find('=');
    const bool has_code = mark != std::string::npos && mark > 0 &&
                          text.find_first_not_of("0123456789") == mark && mark < 6;
    const auto effect = has_code ? pendant::key_effect(text.substr(mark + 1)) : std::nullopt;
    if (!effect)
      throw CLI::ValidationError("--on " + text,
                                 "write CODE=AXIS, CODE=step:MM, CODE=hold or CODE=resume; --show "
                                 "prints the codes of the keys");
    keys.insert_or_assign(std::stoi(text), *effect);
  }
  return keys;
}

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// Asks the machine. What begins motion says which state of it was seen just before, so that it is
// refused where it comes late.
class PendantDesk {
 public:
  PendantDesk(OperatorClient& client, int channel) : client_(client), channel_(channel) {}

  void operator()(const pendant::Turn& turn) {
    ask("handwheel", {{"axis", turn.axis}, {"way", turn.way}, {"seen_cycle", cycle()}});
  }
  void operator()(const pendant::Hold& /*hold*/) { ask("program.hold", json::object()); }
  void operator()(const pendant::Resume& /*resume*/) {
    ask("program.resume", {{"seen_cycle", cycle()}});
  }

 private:
  [[nodiscard]] static OperatorClient::Deadline soon() {
    return OperatorClient::Clock::now() + std::chrono::seconds(2);
  }
  [[nodiscard]] json cycle() {
    const auto status = client_.call("machine.status", json::object(), soon());
    return status ? status->value("cycle", json()) : json();
  }
  // A refusal is said once, until something is accepted.
  void ask(const std::string& method, json parameters) {
    if (channel_ > 0) parameters["channel"] = channel_;
    if (parameters.contains("seen_cycle") && parameters["seen_cycle"].is_null())
      parameters.erase("seen_cycle");
    const auto answer = client_.call(method, parameters, soon());
    const std::string refusal =
        answer ? "" : "[" + answer.error().code + "] " + answer.error().message;
    if (!refusal.empty() && refusal != refusal_) write_message(refusal + "\n");
    refusal_ = refusal;
  }

  OperatorClient& client_;
  int channel_;
  std::string refusal_;
};

int show_events(EventReader& reader) {
  while (!is_interrupted()) {
    const auto events = reader.next();
    if (!events) return 0;
    for (const input_event& event : *events)
      if (const std::string text = text_of(event); !text.empty()) write_data_now(text + "\n");
  }
  return 0;
}

int follow_wheel(EventReader& reader, const PendantOptions& options) {
  Pendant pendant({.axis = options.axis, .step = options.step, .keys = options.keys});
  OperatorClient client(choose_socket(options.socket));
  PendantDesk desk(client, options.channel);
  write_message("listening to " + options.device + "; Ctrl-C ends\n");
  int dropped = 0;
  while (!is_interrupted()) {
    const auto events = reader.next();
    if (!events) throw std::runtime_error("the device " + options.device + " is gone");
    for (const pendant::Order& order : pendant.orders(*events, now_s())) std::visit(desk, order);
    if (pendant.dropped() > dropped)
      write_message(
          options.axis.empty() && options.keys.empty()
              ? "no axis is chosen: give --axis\n"
              : "turns of the wheel were dropped: they came late, or no axis is chosen\n");
    dropped = pendant.dropped();
  }
  return 0;
}

int run_pendant(const PendantOptions& options) {
  catch_interrupts();
  EventReader reader(options.device);
  return options.shows ? show_events(reader) : follow_wheel(reader, options);
}

}  // namespace

void add_pendant_command(CLI::App& app, const std::string& socket, int& exit_code) {
  const auto options = std::make_shared<PendantOptions>();
  CLI::App* command = app.add_subcommand(
      "pendant", "move axes by the wheel and the keys of an input device of this computer");
  command->add_option("device", options->device, "input device, for example /dev/input/event5")
      ->required()
      ->type_name("FILE");
  command->add_option("--axis", options->axis, "axis that the wheel moves at first")
      ->type_name("AXIS");
  command->add_option("--step", options->step, "way of one notch at first, in mm or deg")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--on", options->key_texts,
                   "what a key does: CODE=AXIS, CODE=step:MM, CODE=hold or CODE=resume")
      ->type_name("CODE=WHAT");
  command->add_option("--channel", options->channel, "channel whose axes move")->type_name("ID");
  command->add_flag("--show", options->shows, "only print the events of the device, to find codes");
  command->add_option("--socket", options->socket, "socket of the daemon")->type_name("PATH");
  command->callback([options, &socket, &exit_code] {
    if (options->socket.empty()) options->socket = socket;
    options->keys = keys_of(options->key_texts);
    exit_code = run_pendant(*options);
  });
}

}  // namespace stanok::client

#include "daemon/desk/stop_desk.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

constexpr auto standing_cycle_time_max = std::chrono::seconds(2);

CommandResult refused_stop(const char* code, std::string text, int channel) {
  const FailureKind kind =
      code == std::string_view("E9006") ? FailureKind::timed_out : FailureKind::refused;
  return Unexpected<Failure>(Failure{kind, code, std::move(text), channel, {}});
}

}  // namespace

bool StopDesk::take(protocol::Role role, const protocol::RpcRequest& request, Answer answer) {
  const protocol::Method* method = protocol::find_method(request.method);
  if (method == nullptr || method->effect != protocol::Effect::stops) return false;
  const auto parameters = admitted_parameters(machine_.file(), role, method, request);
  if (!parameters) return answer(Unexpected<Failure>(parameters.error())), true;
  auto stop = operator_event(machine_.file(), *method, *parameters);
  if (!stop) return answer(Unexpected<Failure>(stop.error())), true;
  stop->id = ++last_id_ | channels::stop_id_mark;
  if (!machine_.submit_stop(*stop))
    return answer(refused_stop("E9007", "there are too many requests at once", stop->channel)),
           true;
  pending_.emplace(stop->id, Pending{*stop, std::move(answer)});
  return true;
}

void StopDesk::order(const channels::OperatorCommand& command) {
  channels::OperatorEvent event;
  event.command = command;
  // The queue keeps room; were it full all the same, those in it are stops.
  static_cast<void>(machine_.submit_stop(event));
}

void StopDesk::on_reply(const channels::OperatorReply& reply) {
  auto node = pending_.extract(reply.id);
  if (node.empty()) return;  // answered already, because the cycle had stood
  const Pending& pending = node.mapped();
  if (!reply.ok) {
    const std::string code(reply.code.view());
    return pending.answer(
        refused_stop(code.c_str(), std::string(reply.text.view()), pending.stop.channel));
  }
  on_accepted_(pending.stop);
  pending.answer(json{{"accepted", true}});
}

void StopDesk::tick(SteadyTime now) {
  const std::int64_t cycle = machine_.cycles();
  if (cycle != newest_cycle_ || pending_.empty()) {
    newest_cycle_ = cycle;
    newest_cycle_seen_ = now;
  }
  if (now - newest_cycle_seen_ < standing_cycle_time_max) return;
  std::map<std::uint64_t, Pending> given_up;
  given_up.swap(pending_);
  for (const auto& [id, pending] : given_up)
    pending.answer(refused_stop("E9006",
                                "the machine does not answer: its real-time cycle has stopped",
                                pending.stop.channel));
}

}  // namespace stanok::daemon

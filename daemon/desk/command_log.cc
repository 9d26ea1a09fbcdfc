#include "daemon/desk/command_log.h"

#include <spdlog/spdlog.h>

#include "protocol/contract/json_text.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

constexpr std::size_t parameters_bytes_max = 1000;  // of a record

// A jog is renewed many times a second: what it is told by is its axis moving.
bool is_remembered(const protocol::RpcRequest& request) {
  return request.method != "jog" && request.method != "program.retrace";
}

}  // namespace

void CommandLog::note(const Asker& asker, const protocol::RpcRequest& request,
                      const CommandResult& outcome) const {
  const std::string parameters = protocol::json_text(request.parameters);
  if (outcome) {
    spdlog::info("session {} ({}): {} {}: done", asker.session, asker.peer, request.method,
                 parameters);
  } else {
    spdlog::warn("session {} ({}): {} {}: {} {}", asker.session, asker.peer, request.method,
                 parameters, outcome.error().code, outcome.error().message);
  }
  if (journal_ == nullptr || !is_remembered(request)) return;
  json record = {{"kind", journal_kind::action},
                 {"session", asker.session},
                 {"by", asker.peer},
                 {"method", request.method},
                 {"outcome", outcome ? "done" : outcome.error().code}};
  if (parameters.size() <= parameters_bytes_max) record["parameters"] = request.parameters;
  if (!outcome) record["text"] = outcome.error().message;
  journal_->add(std::move(record));
}

void CommandLog::note_seen(int channel, std::uint64_t number) const {
  if (journal_ != nullptr) journal_->add(seen_record(channel, number));
}

}  // namespace stanok::daemon

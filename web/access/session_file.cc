#include "web/access/session_file.h"

#include <sodium.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"
#include "web/access/private_file.h"

namespace stanok::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::system_clock;

std::string hex_of(const SecretHash& hash) {
  std::string text(2 * hash.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), hash.data(), hash.size());
  text.pop_back();  // the zero that ends it
  return text;
}

SecretHash hash_from(const std::string& hex) {
  SecretHash hash{};
  std::size_t bytes = 0;
  const bool is_read = sodium_hex2bin(hash.data(), hash.size(), hex.data(), hex.size(), nullptr,
                                      &bytes, nullptr) == 0;
  if (!is_read || bytes != hash.size() || hex.size() != 2 * hash.size())
    throw std::runtime_error("a hash has 64 hexadecimal digits");
  return hash;
}

std::int64_t seconds_of(system_clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

system_clock::time_point time_from(const json& seconds) {
  constexpr double seconds_max = 4e9;
  const auto given = seconds.get<double>();
  if (!(given >= 0 && given <= seconds_max)) throw std::runtime_error("a time is not valid");
  return system_clock::time_point(std::chrono::seconds(static_cast<std::int64_t>(given)));
}

json json_of(const KeptSession& kept) {
  return {{"secret", hex_of(kept.secret)},
          {"key", hex_of(kept.key)},
          {"name", kept.identity.name},
          {"role", protocol::role_name(kept.identity.role)},
          {"password_hash", kept.identity.password_hash},
          {"begun_s", seconds_of(kept.begun)},
          {"used_s", seconds_of(kept.used)}};
}

KeptSession session_from(const json& kept) {
  const auto role = protocol::role_named(kept.at("role").get<std::string>());
  if (!role) throw std::runtime_error("unknown role");
  return {.secret = hash_from(kept.at("secret").get<std::string>()),
          .key = hash_from(kept.at("key").get<std::string>()),
          .identity = {.name = kept.at("name").get<std::string>(),
                       .role = *role,
                       .password_hash = kept.at("password_hash").get<std::string>()},
          .begun = time_from(kept.at("begun_s")),
          .used = time_from(kept.at("used_s"))};
}

}  // namespace

std::string text_of(const std::vector<KeptSession>& sessions) {
  json list = json::array();
  for (const KeptSession& kept : sessions) list.push_back(json_of(kept));
  return protocol::json_text(json{{"sessions", list}}) + '\n';
}

std::vector<KeptSession> sessions_from_file(const fs::path& file) {
  std::error_code error;
  if (fs::status(file, error).type() == fs::file_type::not_found) return {};
  refuse_open_file(file);
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::vector<KeptSession> sessions;
  try {
    const json content = protocol::json_from_text(text);
    for (const json& kept : content.at("sessions")) sessions.push_back(session_from(kept));
  } catch (const std::exception& defect) {
    throw std::runtime_error(file.string() + ": " + defect.what());
  }
  return sessions;
}

}  // namespace stanok::web

#include "gateway/broker/broker_connection.h"

#include <fstream>
#include <utility>

namespace stanok::gateway {
namespace {

using namespace std::chrono_literals;

constexpr auto connect_time_max = 10s;
constexpr int keepalive_s = 10;
constexpr int at_least_once = 1;

void check(int result, const std::string& doing) {
  if (result != MOSQ_ERR_SUCCESS) throw BrokerError(doing + ": " + mosquitto_strerror(result));
}

std::string first_line_of(const std::filesystem::path& file) {
  std::string line;
  if (!std::getline(std::ifstream(file), line)) throw BrokerError(file.string() + ": no password");
  return line;
}

const char* text_or_null(const std::filesystem::path& path) {
  return path.empty() ? nullptr : path.c_str();
}

}  // namespace

BrokerConnection::BrokerConnection(const BrokerOptions& options, const Will& will)
    : begun_(std::chrono::steady_clock::now()) {
  constexpr bool keeps_nothing = true;
  client_.reset(mosquitto_new(nullptr, keeps_nothing, this));
  if (client_ == nullptr) throw BrokerError("cannot create a client of the broker");
  configure(options, will);
  check(mosquitto_connect_async(client_.get(), options.host.c_str(), options.port, keepalive_s),
        options.host + ":" + std::to_string(options.port));
}

BrokerConnection::~BrokerConnection() = default;

void BrokerConnection::configure(const BrokerOptions& options, const Will& will) {
  mosquitto* const client = client_.get();
  mosquitto_connect_callback_set(client, on_connect);
  mosquitto_publish_callback_set(client, on_publish);
  mosquitto_message_callback_set(client, on_message);
  // All that is published may be on its way: the caller bounds it.
  mosquitto_max_inflight_messages_set(client, 0);
  check(mosquitto_will_set(client, will.topic.c_str(), static_cast<int>(will.payload.size()),
                           will.payload.data(), at_least_once,
                           will.keeping == Will::Keeping::retained),
        "last will");
  if (!options.user.empty()) {
    const std::string password =
        options.password_file.empty() ? "" : first_line_of(options.password_file);
    check(mosquitto_username_pw_set(client, options.user.c_str(), password.c_str()), "user");
  }
  if (options.tls_ca.empty()) return;
  check(mosquitto_tls_set(client, options.tls_ca.c_str(), nullptr,
                          text_or_null(options.tls_certificate), text_or_null(options.tls_key),
                          nullptr),
        "TLS");
  check(mosquitto_tls_opts_set(client, 1, "tlsv1.2", nullptr), "TLS");
}

void BrokerConnection::on_connect(mosquitto* /*unused*/, void* self, int result) {
  auto& connection = *static_cast<BrokerConnection*>(self);
  connection.is_connected_ = result == 0;
  if (result != 0) connection.refused_ = mosquitto_connack_string(result);
}

void BrokerConnection::on_publish(mosquitto* /*unused*/, void* self, int number) {
  static_cast<BrokerConnection*>(self)->acknowledged_.insert(number);
}

void BrokerConnection::on_message(mosquitto* /*unused*/, void* self,
                                  const mosquitto_message* message) {
  constexpr std::size_t kept_max = 100;
  std::vector<std::string>& messages = static_cast<BrokerConnection*>(self)->messages_;
  if (messages.size() == kept_max) messages.erase(messages.begin());
  messages.emplace_back(static_cast<const char*>(message->payload),
                        static_cast<std::size_t>(message->payloadlen));
}

void BrokerConnection::step(std::chrono::milliseconds patience) {
  constexpr int packets = 1;
  const int result = mosquitto_loop(client_.get(), static_cast<int>(patience.count()), packets);
  if (!refused_.empty()) throw BrokerError(refused_);
  check(result, is_connected_ ? "connection lost" : "no connection");
  if (!is_connected_ && std::chrono::steady_clock::now() - begun_ > connect_time_max)
    throw BrokerError("the broker does not answer");
}

bool BrokerConnection::has_sent_all() const {
  return !mosquitto_want_write(client_.get());
}

void BrokerConnection::publish_retained(const std::string& topic, const std::string& payload) {
  constexpr bool retained = true;
  check(mosquitto_publish(client_.get(), nullptr, topic.c_str(), static_cast<int>(payload.size()),
                          payload.data(), 0, retained),
        topic);
}

void BrokerConnection::publish_once(const std::string& topic, const std::string& payload) {
  check(mosquitto_publish(client_.get(), nullptr, topic.c_str(), static_cast<int>(payload.size()),
                          payload.data(), 0, false),
        topic);
}

void BrokerConnection::subscribe(const std::string& topic) {
  check(mosquitto_subscribe(client_.get(), nullptr, topic.c_str(), at_least_once), topic);
}

std::vector<std::string> BrokerConnection::take_messages() {
  return std::exchange(messages_, {});
}

int BrokerConnection::publish(const std::string& topic, const std::string& payload) {
  int number = 0;
  constexpr bool retained = false;
  check(mosquitto_publish(client_.get(), &number, topic.c_str(), static_cast<int>(payload.size()),
                          payload.data(), at_least_once, retained),
        topic);
  return number;
}

std::set<int> BrokerConnection::take_acknowledged() {
  return std::exchange(acknowledged_, {});
}

void BrokerConnection::end() {
  mosquitto_disconnect(client_.get());
  constexpr auto goodbye = 100ms;
  mosquitto_loop(client_.get(), static_cast<int>(goodbye.count()), 1);
}

}  // namespace stanok::gateway

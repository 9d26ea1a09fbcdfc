// How the broker is reached.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace stanok::gateway {

struct BrokerOptions {
  std::string host = "127.0.0.1";
  int port = 1883;
  std::string user;                     // empty: without
  std::filesystem::path password_file;  // its first line
  std::filesystem::path tls_ca;         // empty: no TLS
  std::filesystem::path tls_certificate;
  std::filesystem::path tls_key;
  // Events acknowledged later than that before a connection was lost are sent again.
  std::chrono::seconds resent{10};
};

}  // namespace stanok::gateway

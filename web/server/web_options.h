// WebOptions: what the command line of stanok-web says, and what must not be.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace stanok::web {

// The command line asks for what is not done; it says what to do instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WebOptions {
  boost::asio::ip::tcp::endpoint listen;
  std::vector<std::filesystem::path> sockets;  // of the daemons; the first is shown as a rule
  std::string history;                // of the gateway: file or postgresql://...; empty: none
  std::filesystem::path link_socket;  // where links are given out
  std::filesystem::path page;
  std::filesystem::path manual;           // the documents that the page shows; may be missing
  std::filesystem::path users;            // empty: none
  std::filesystem::path sessions;         // what outlives the server; empty: nothing
  std::filesystem::path tls_certificate;  // empty: no TLS
  std::filesystem::path tls_key;
  std::vector<std::string> names;  // by which browsers may call the server
};

// Throws UsageError.
void check(const WebOptions& options);

}  // namespace stanok::web

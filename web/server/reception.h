// Reception: answers every request but that for a WebSocket: files of the page and of its manual,
// sessions, the method table, health.
//
// One thread.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/address.hpp>
#include <optional>
#include <string>

#include "web/access/request_origin.h"
#include "web/server/answer.h"
#include "web/server/authentication.h"
#include "web/server/daemon_probe.h"
#include "web/server/page_files.h"

namespace stanok::web {

class Reception {
 public:
  // All outlive the reception.
  Reception(PageFiles& page, PageFiles& manual, Authentication& authentication,
            DaemonProbe& machine, const OwnNames& names);

  // Why the request is not for this server, or comes from the page of another one.
  [[nodiscard]] std::optional<Answer> obstacle(const Request& request) const;
  // `request` outlives the answer; `from` is where it came from.
  [[nodiscard]] boost::asio::awaitable<Answer> answer(const Request& request,
                                                      boost::asio::ip::address from);

 private:
  [[nodiscard]] boost::asio::awaitable<Answer> answer_session(const Request& request,
                                                              boost::asio::ip::address from);
  [[nodiscard]] boost::asio::awaitable<Answer> begin_session(const Request& request,
                                                             boost::asio::ip::address from);
  [[nodiscard]] boost::asio::awaitable<Answer> describe_session(const Request& request);
  [[nodiscard]] boost::asio::awaitable<Answer> health();
  [[nodiscard]] Answer page_file(const Request& request);
  [[nodiscard]] Answer manual_file(const Request& request);

  PageFiles& page_;
  PageFiles& manual_;
  Authentication& authentication_;
  DaemonProbe& machine_;
  const OwnNames& names_;
  Answer methods_;
};

// The path of a request, without what stands behind a question mark.
[[nodiscard]] std::string_view path_of(const Request& request);

}  // namespace stanok::web

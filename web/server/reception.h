// Reception: answers every request but that for a WebSocket: files of the page and of its manual,
// sessions, the method table, the machines and their history, health.
//
// One thread.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/address.hpp>
#include <optional>
#include <string>

#include "web/access/request_origin.h"
#include "web/cell/history_desk.h"
#include "web/cell/machine_list.h"
#include "web/server/answer.h"
#include "web/server/authentication.h"
#include "web/server/page_files.h"

namespace stanok::web {

// What is shown; all of it outlives the reception.
struct Exhibits {
  PageFiles& page;
  PageFiles& manual;
  MachineList& machines;
  HistoryDesk& history;
};

class Reception {
 public:
  // All outlive the reception.
  Reception(const Exhibits& exhibits, Authentication& authentication, const OwnNames& names);

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
  [[nodiscard]] boost::asio::awaitable<Answer> overview(const Request& request);
  [[nodiscard]] boost::asio::awaitable<Answer> history(const Request& request);
  [[nodiscard]] boost::asio::awaitable<Answer> health();
  [[nodiscard]] Answer page_file(const Request& request);
  [[nodiscard]] Answer manual_file(const Request& request);

  Exhibits exhibits_;
  Authentication& authentication_;
  const OwnNames& names_;
  Answer methods_;
};

// The path of a request, without what stands behind a question mark.
[[nodiscard]] std::string_view path_of(const Request& request);

}  // namespace stanok::web

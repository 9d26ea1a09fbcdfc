// SessionList: the clients that are connected, the oldest first, and how many of them have a place.
//
// Sessions may end while something is sent to them: who goes over all of them takes a copy.
// Belongs to the reception's thread, but for `places_taken`. Invariant: `places_taken` is what the
// sessions said when they were counted last, which every change of the list does.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "daemon/server/session.h"

namespace stanok::daemon {

class SessionList {
 public:
  // Ids are never given twice.
  [[nodiscard]] int next_id() { return ++last_id_; }
  void add(const std::shared_ptr<Session>& session) { sessions_.emplace(session->id(), session); }
  void forget(int id);
  // Who has been told to go lingers until it has read that, but has no place any more.
  void count_places();
  [[nodiscard]] std::size_t places_taken() const { return places_taken_; }  // any thread

  [[nodiscard]] std::size_t size() const { return sessions_.size(); }
  [[nodiscard]] std::vector<std::shared_ptr<Session>> all() const;

  // Ends the session of the observer who has been here longest; false: there is none.
  [[nodiscard]] bool make_room();
  // Ends the session that was turned away first; false: there is none.
  [[nodiscard]] bool end_oldest_turned_away(Session::Time now);

 private:
  using Condition = std::function<bool(const Session& session)>;
  [[nodiscard]] std::shared_ptr<Session> oldest(const Condition& condition) const;

  std::map<int, std::shared_ptr<Session>> sessions_;  // by id
  int last_id_ = 0;
  std::atomic<std::size_t> places_taken_{0};
};

}  // namespace stanok::daemon

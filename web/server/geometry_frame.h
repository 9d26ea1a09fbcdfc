// Pages of geometry on their way to a browser: out of the daemon's JSON into binary frames.
//
// A result of the daemon has a page as base64 in its member `geometry`. The browser gets the page
// as a frame: kind, id, page and count as uint32, then count points as Float32 (x, y, z), then
// count lines as Uint32, all little endian; and the message without the base64.
#pragma once

#include <optional>
#include <string>

namespace stanok::web {

struct GeometryMessage {
  std::string frame;    // binary
  std::string message;  // the text, without what is in the frame
  std::string more;     // the request for the next page; empty: there is none
  bool is_own = false;  // answers a request for a next page, which the browser did not send
};

// Nothing: the line of the daemon is an ordinary message, or its page is none.
[[nodiscard]] std::optional<GeometryMessage> geometry_of(const std::string& line);

}  // namespace stanok::web

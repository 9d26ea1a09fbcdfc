// The file that sessions outlive the server in: JSON, with hashes of their secrets only.
//
//   {"sessions": [{"secret": "3f..", "key": "a0..", "name": "anna", "role": "operator",
//                  "password_hash": "$argon2id..", "begun_s": 1790000000, "used_s": 1790003600}]}
//
// Times are seconds since 1970. Private (web/access/private_file.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "web/access/sessions.h"

namespace stanok::web {

[[nodiscard]] std::string text_of(const std::vector<KeptSession>& sessions);

// A file that is not there has none. Throws std::runtime_error with the file and the reason.
[[nodiscard]] std::vector<KeptSession> sessions_from_file(const std::filesystem::path& file);

}  // namespace stanok::web

#include "web/server/web_options.h"

#include "gateway/database/database.h"
#include "web/cell/machine_list.h"
#include "web/server/listen_address.h"

namespace stanok::web {

// On other addresses than loopback everybody in the network knocks, and reads along.
void check(const WebOptions& options) {
  if (options.tls_certificate.empty() != options.tls_key.empty())
    throw UsageError("--tls-cert and --tls-key belong together");
  if (const auto why = confusion(options.sockets); !why.empty()) throw UsageError(why);
  if (gateway::is_server(options.history) && gateway::holds_password(options.history))
    throw UsageError(
        "--history: do not put a password in an address; write it to the file that PGPASSFILE "
        "names");
  if (options.listen.address().is_loopback()) return;
  std::string missing;
  if (options.tls_certificate.empty()) missing += "\n  --tls-cert FILE --tls-key FILE";
  if (options.users.empty())
    missing += "\n  --users FILE, created with: stanok-web user add NAME --role ROLE --users FILE";
  if (missing.empty()) return;
  throw UsageError(
      text_of(options.listen) + " is not a loopback address, so TLS and users are required; add" +
      missing +
      "\nor listen on 127.0.0.1 and use a tunnel: ssh -L 8080:127.0.0.1:8080 THIS_COMPUTER");
}

}  // namespace stanok::web

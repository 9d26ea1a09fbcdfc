// Gateway: readers of all machines in one thread, publisher and history each in another one, and
// the outbox between them.
#pragma once

#include "gateway/start/gateway_options.h"

namespace stanok::gateway {

// Until SIGINT or SIGTERM. Throws UsageError, and DatabaseError when there can be no outbox.
void run_gateway(const GatewayOptions& options);

}  // namespace stanok::gateway

// SPDX-License-Identifier: GPL-3.0-or-later
// How the encoders refuse a request before it is sent. Pure functions, any thread.
#pragma once

#include "base/error.h"
#include "protocol/request.h"

namespace protocol {
/// The name of an operation in errors: "ping", "reg-write", "sync-read".
QString operationName(Op op);

/// BadArgument; `detail` states what is wrong with the request.
tl::unexpected<base::Error> refuse(const Request& request, const QString& detail);

/// NotSupported: the protocol of the request has no such instruction.
tl::unexpected<base::Error> refuseUnsupported(const Request& request);

/// The bytes of a raw request as they are, if there are any and at most `maxSize`.
base::Result<base::Bytes> encodeRaw(const Request& request, std::size_t maxSize);
} // namespace protocol

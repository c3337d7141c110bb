// SPDX-License-Identifier: GPL-3.0-or-later
// How the encoders say no, before anything is sent. Pure functions, any thread.
#pragma once

#include "base/error.h"
#include "protocol/request.h"

namespace protocol {
/// BadArgument; `why` tells what is wrong with the request.
tl::unexpected<base::Error> refuse(const Request& request, const QString& detail);

/// NotSupported: the request's language has nothing of the kind.
tl::unexpected<base::Error> refuseUnsupported(const Request& request);

/// The bytes of a raw request as they are, if there are any and at most `longest`.
base::Result<base::Bytes> encodeRaw(const Request& request, std::size_t maxSize);
} // namespace protocol

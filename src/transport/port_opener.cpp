// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/port_opener.h"

#include "transport/serial_link.h"
#include "transport/tcp_link.h"

namespace transport {
base::Result<std::unique_ptr<Link>> openPort(const PortSpec& spec, base::Clock&)
{
    if (spec.name.isEmpty())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("open"),
                          QStringLiteral("no port named"));
    if (spec.name.contains(QLatin1String("://")))
        return openTcp(spec);
    return openSerial(spec);
}

const std::vector<int>& standardBaudRates()
{
    static const std::vector<int> rates{1'000'000, 500'000, 256'000, 250'000, 128'000,
                                        115'200,   76'800,  57'600,  56'000,  38'400,
                                        19'200,    14'400,  9'600,   4'800};
    return rates;
}
} // namespace transport

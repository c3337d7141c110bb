// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/search/diagnosis_spec.h"

#include "session/session.h"
#include "transport/port_lease.h"

namespace session {
jobs::DiagnosisSpec diagnosisSpec(const PortRequest& port)
{
    jobs::DiagnosisSpec spec;
    spec.bauds = standardBaudRates();
    if (port.protocol)
        spec.protocols = {*port.protocol};
    if (port.name.startsWith(QLatin1Char('/'))) {
        const QString path = transport::canonicalPath(port.name);
        spec.otherPrograms = transport::portHolders(path);
        spec.latencyTimer = transport::latencyTimer(path);
    }
    return spec;
}
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/search/diagnosis_spec.h"

#include "session/session.h"
#include "transport/port_lease.h"

namespace session {
namespace {
/// "USB Serial, QinHeng"; empty: unknown.
QString adapterAt(const QString& path)
{
    for (const transport::PortInfo& info : transport::listPorts()) {
        if (info.path != path)
            continue;
        QStringList words{info.description, info.manufacturer};
        words.removeAll(QString());
        return words.join(QStringLiteral(", "));
    }
    return {};
}
} // namespace

jobs::DiagnosisSpec diagnosisSpec(const PortRequest& port)
{
    jobs::DiagnosisSpec spec;
    spec.bauds = standardBaudRates();
    if (port.protocol)
        spec.protocols = {*port.protocol};
    if (port.name.startsWith(QLatin1Char('/'))) {
        const QString path = transport::canonicalPath(port.name);
        spec.adapter = adapterAt(path);
        spec.otherPrograms = transport::portHolders(path);
        spec.latencyTimer = transport::latencyTimer(path);
    }
    return spec;
}
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/bus_text.h"

#include "text/language.h"
#include "text/translate.h"

#include <array>
#include <utility>

namespace text {
QString protocolText(base::Protocol protocol)
{
    switch (protocol) {
    case base::Protocol::Modbus:
        return QStringLiteral("Modbus");
    case base::Protocol::Lx:
        return QStringLiteral("LX");
    case base::Protocol::Feetech:
        break;
    }
    return translate("BusText", "Feetech");
}

QString idRangesText(const std::vector<int>& ids)
{
    QStringList parts;
    for (std::size_t first = 0; first < ids.size();) {
        std::size_t last = first;
        while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1)
            ++last;
        const QString from = QString::number(ids[first]);
        parts << (last == first ? from : QStringLiteral("%1–%2").arg(from).arg(ids[last]));
        first = last + 1;
    }
    return joinItems(parts);
}

QString simulatedBusText(const QString& port)
{
    static constexpr std::array buses{
        std::pair{"sim:demo", QT_TRANSLATE_NOOP("BusText", "six servos, one with an alarm")},
        std::pair{
            "sim:trouble",
            QT_TRANSLATE_NOOP("BusText", "mixed baud rates, two servos sharing one ID, faults")},
        std::pair{"sim:modbus", QT_TRANSLATE_NOOP("BusText", "one SMS servo on Modbus-RTU")},
        std::pair{"sim:lx", QT_TRANSLATE_NOOP("BusText", "five Hiwonder LX servos")},
        std::pair{"sim:sweep",
                  QT_TRANSLATE_NOOP("BusText", "a good, a worn and a badly damped servo to test")},
        std::pair{"sim:new-arm", QT_TRANSLATE_NOOP("BusText", "six new servos, all with ID 1")},
        std::pair{"sim:so101", QT_TRANSLATE_NOOP("BusText", "robot arm SO-101, not calibrated")},
        std::pair{"sim:line", QT_TRANSLATE_NOOP("BusText", "six new servos to commission")},
        std::pair{"sim:line-trouble",
                  QT_TRANSLATE_NOOP("BusText", "six servos to commission, some with faults")}};
    for (const auto& [name, words] : buses) {
        if (port == QLatin1StringView(name))
            return translate("BusText", words);
    }
    return {};
}
} // namespace text

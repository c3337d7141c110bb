// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/bus_text.h"

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/rate_text.h"

#include <QCoreApplication>

namespace ui {
namespace {
constexpr int mega = 1'000'000;
constexpr int kilo = 1000;
constexpr int roundKilo = 100'000;
constexpr double minute = 60;
constexpr double maxSeconds = 99;
} // namespace

QString rateText(int baud)
{
    QString digits = QString::number(baud);
    for (auto place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, QChar(0x202F)); // narrow blank that does not break
    return digits;
}

QString shortRate(int baud)
{
    if (baud >= mega && baud % roundKilo == 0)
        return QStringLiteral("%1 M").arg(double(baud) / mega);
    if (baud >= roundKilo && baud % roundKilo == 0)
        return QStringLiteral("%1 k").arg(baud / kilo);
    return QString::number(baud);
}

QString spanText(base::Duration span)
{
    const double seconds = double(span.count()) / 1e6;
    if (seconds < 9.95)
        return QCoreApplication::translate("ui", "%1 s").arg(seconds, 0, 'f', 1);
    if (seconds < maxSeconds)
        return QCoreApplication::translate("ui", "%1 s").arg(qRound(seconds));
    return QCoreApplication::translate("ui", "%1 min").arg(qRound(seconds / minute));
}

QString timeAgoText(base::Duration age)
{
    constexpr int nowThreshold = 2;
    constexpr int minuteSeconds = 60;
    const auto seconds = int(age.count() / 1'000'000);
    if (seconds < nowThreshold)
        return QCoreApplication::translate("ServoRow", "now", "last seen");
    if (seconds < minuteSeconds)
        return QCoreApplication::translate("ServoRow", "%1 s ago").arg(seconds);
    return QCoreApplication::translate("ServoRow", "%1 min ago").arg(seconds / minuteSeconds);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// Machine time of a commissioning line: from plugging a servo in to "unplug", on simulated time.
// Usage: bench_commission [preset [baud]]; the goal is 10 s a servo.
#include "support/commission_fixture.h"

#include <cstdio>

int main(int argc, char** argv)
{
    support::CommissionFixture line(argc > 1 ? QString::fromLocal8Bit(argv[1])
                                             : QStringLiteral("line"));
    line.spec.baud = argc > 2 ? QByteArray(argv[2]).toInt() : 500'000;
    const auto end = line.run();
    if (!end) {
        std::printf("failed: %s\n", qPrintable(base::errorName(end.error().code)));
        return 1;
    }
    double worst = 0;
    for (std::size_t i = 0; i < line.spans.size() && i < line.batch.rows.size(); ++i) {
        const results::CommissionRow& row = line.batch.rows[i];
        const double seconds = std::chrono::duration<double>(line.spans[i]).count();
        worst = std::max(worst, seconds);
        std::printf("%zu %-10s %7d baud  %-9s %6.2f s\n", i + 1, qPrintable(row.servo.model),
                    row.oldBaud, qPrintable(results::verdictName(row.verdict)), seconds);
    }
    std::printf("slowest: %.2f s (goal 10 s), clicks: 0\n", worst);
    return worst <= 10 ? 0 : 1;
}

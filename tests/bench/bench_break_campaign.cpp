// SPDX-License-Identifier: GPL-3.0-or-later
// Kills every writing command (SIGKILL) and cuts its cable at random moments, and counts what is
// left:
//   bench_break_campaign [rounds a command [seed]]
// 20 rounds of ten commands are 200 of each kind. Exit code 1 if a servo was left unlocked or lost,
// a claim was false, or a program hung.
#include "support/campaign.h"

#include <QCoreApplication>

#include <cstdio>
#include <cstdlib>

using support::Break;

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 20;
    const auto seed = std::uint32_t(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
    const struct {
        const char* name;
        Break how;
        bool noisy;
    } kinds[] = {
        {"killed", Break::Kill, false},
        {"killed, 2 % of frames disturbed", Break::Kill, true},
        {"terminal gone", Break::CutTerminal, false},
        {"TCP link dropped", Break::CutTcp, false},
    };
    bool clean = true;
    for (const auto& kind : kinds) {
        std::printf("== %s, seed %u\n", kind.name, seed);
        const auto tally =
            support::runCampaign(kind.how, rounds, kind.noisy, seed, [](const QString& line) {
                std::printf("%s\n", qPrintable(line));
                std::fflush(stdout);
            });
        clean = clean && tally.clean();
        std::printf("in all %d rounds, %d broken: %s%s\n", tally.rounds, tally.broken,
                    tally.clean() ? "clean" : "TROUBLE: ", qPrintable(tally.firstTrouble));
    }
    return clean ? 0 : 1;
}

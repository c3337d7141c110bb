// SPDX-License-Identifier: GPL-3.0-or-later
// Kills every writing command (SIGKILL), without and with noise on the wire, and cuts its cable,
// each at random moments between its first write and its end, and counts what is left:
//   bench_interruption_campaign [rounds of each kind, 200 [seed, 1 [command]]]
// Exit code 1 if a servo was left unlocked or lost, a claim was false, a program hung, or no break
// of a command met an open change.
#include "support/interruption_campaign.h"

#include <QCoreApplication>

#include <cstdio>
#include <cstdlib>

using support::CampaignTotals;
using support::Interruption;

namespace {
struct Kind {
    const char* name;
    Interruption how;
};
constexpr Kind kinds[] = {
    {"killed", Interruption::Kill},
    {"killed in noise", Interruption::KillDuringNoise},
    {"cable cut", Interruption::LinkCut},
};

void printRow(const char* name, const CampaignTotals& tally)
{
    std::printf("%-16s %7d %11d %13d %13d %5d %12d %14d %5d\n", name, tally.rounds, tally.broken,
                tally.openChanges, tally.unlocked, tally.lost, tally.falseClaimCount,
                tally.unrecovered, tally.hung);
}
} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 200;
    const auto seed = std::uint32_t(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
    const QString only = argc > 3 ? QString::fromLocal8Bit(argv[3]) : QString();
    CampaignTotals sum;
    std::vector<CampaignTotals> tallies;
    for (const Kind& kind : kinds) {
        std::printf("== %s, seed %u\n", kind.name, seed);
        std::fflush(stdout);
        tallies.push_back(
            support::runCampaign(kind.how, rounds, seed, only, [](const QString& line) {
                std::printf("%s\n", qPrintable(line));
                std::fflush(stdout);
            }));
        sum += tallies.back();
    }
    std::printf("\n%-16s %7s %11s %13s %13s %5s %12s %14s %5s\n", "", "rounds", "broken off",
                "changes open", "left unlocked", "lost", "false words", "not recovered", "hung");
    for (std::size_t i = 0; i < tallies.size(); ++i)
        printRow(kinds[i].name, tallies[i]);
    printRow("all", sum);
    std::printf("%s%s\n", sum.clean() ? "clean" : "VIOLATION: ", qPrintable(sum.firstFailure));
    return sum.clean() && sum.broken > 0 ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/refusal_text.h"

#include "text/history_text.h"
#include "text/server_text.h"
#include "text/translate.h"

#include <array>

namespace text {
namespace {
constexpr std::array notSupported{
    RefusalText{"not-position", QT_TRANSLATE_NOOP("text", "it is not in a position mode"),
                QT_TRANSLATE_NOOP("text", "In its present mode goals are no places it could come "
                                          "to."),
                QT_TRANSLATE_NOOP("text", "Tick \"Switch to position mode\" for this test "
                                          "(--switch-mode on the command line), or change to "
                                          "position mode first.")},
    RefusalText{"fixed-rate", QT_TRANSLATE_NOOP("text", "its baud rate cannot be changed"),
                QT_TRANSLATE_NOOP("text", "This family runs at one rate and has no command for "
                                          "another."),
                QT_TRANSLATE_NOOP("text", "Set the other servos and the port to its rate.")},
    RefusalText{"no-reboot", QT_TRANSLATE_NOOP("text", "it has no restart command"),
                QT_TRANSLATE_NOOP("text", "This family knows none."),
                QT_TRANSLATE_NOOP("text", "Switch its supply off and on.")},
    RefusalText{"no-restore", QT_TRANSLATE_NOOP("text", "it cannot restore its defaults itself"),
                QT_TRANSLATE_NOOP("text", "This family has no command for it."),
                QT_TRANSLATE_NOOP("text", "Write the values back one by one.")},
    RefusalText{"no-sync", QT_TRANSLATE_NOOP("text", "it cannot share a packet with others"),
                QT_TRANSLATE_NOOP("text", "This family has no packet for several servos."),
                QT_TRANSLATE_NOOP("text", "Give the goals one by one.")},
    RefusalText{"no-async", QT_TRANSLATE_NOOP("text", "it cannot hold a goal for later"),
                QT_TRANSLATE_NOOP("text", "This family has no write that waits for a start."),
                QT_TRANSLATE_NOOP("text", "Give the goals one by one.")},
    RefusalText{"other-mode", QT_TRANSLATE_NOOP("text", "it is in another mode than the first"),
                QT_TRANSLATE_NOOP("text", "One goal for all would mean something else to it."),
                QT_TRANSLATE_NOOP("text", "Bring all of them into the same mode first.")},
    RefusalText{"mode-first",
                QT_TRANSLATE_NOOP("text", "the mode and its command cannot be written together"),
                QT_TRANSLATE_NOOP("text", "A change of mode begins with its command at zero, so "
                                          "that nothing turns by surprise."),
                QT_TRANSLATE_NOOP("text", "Change the mode first, then give the command.")},
    RefusalText{"speed-by-time", QT_TRANSLATE_NOOP("text", "it has no speed setting"),
                QT_TRANSLATE_NOOP("text", "Its speed follows from the travel time."),
                QT_TRANSLATE_NOOP("text", "Give a time instead.")},
    RefusalText{"not-readable", QT_TRANSLATE_NOOP("text", "it does not answer to this read"),
                QT_TRANSLATE_NOOP("text", "Some models of this family lack the command; the line "
                                          "is in order."),
                QT_TRANSLATE_NOOP("text", "Do without this value.")},
    RefusalText{"with-goal", QT_TRANSLATE_NOOP("text", "the time goes together with a goal"),
                QT_TRANSLATE_NOOP("text", "One command carries both, so writing the time alone "
                                          "would send the last goal once more."),
                QT_TRANSLATE_NOOP("text", "Give goal and time together.")},
    RefusalText{"always-kept", QT_TRANSLATE_NOOP("text", "this setting is always kept"),
                QT_TRANSLATE_NOOP("text", "The servo stores it at once; it has no lock that could "
                                          "prevent that."),
                QT_TRANSLATE_NOOP("text", "Write it to stay, and write the old value back "
                                          "afterwards.")},
    RefusalText{"no-led", QT_TRANSLATE_NOOP("text", "it has no LED that can be switched"),
                QT_TRANSLATE_NOOP("text", "The map of this family has no register for it."),
                QT_TRANSLATE_NOOP("text", "With torque off, turn a shaft by hand and see whose "
                                          "position changes.")},
    RefusalText{"factory-led", QT_TRANSLATE_NOOP("text", "its LED belongs to the factory values"),
                QT_TRANSLATE_NOOP("text", "Making it blink would mean unlocking and rewriting "
                                          "them many times."),
                QT_TRANSLATE_NOOP("text", "With torque off, turn a shaft by hand and see whose "
                                          "position changes.")},
    RefusalText{"release-mode",
                QT_TRANSLATE_NOOP("text", "in this mode there is no small way back from the "
                                          "stall"),
                QT_TRANSLATE_NOOP("text", "Only the opposite direction releases an overload, and "
                                          "here the shaft would turn on and on."),
                QT_TRANSLATE_NOOP("text", "Take the load off and command the other direction "
                                          "yourself, or switch its supply off and on.")},
    RefusalText{"release-direction",
                QT_TRANSLATE_NOOP("text", "nothing tells which way it is stalled"),
                QT_TRANSLATE_NOOP("text", "It stands at its goal and drives neither way."),
                QT_TRANSLATE_NOOP("text", "Take the load off and give a goal away from the stall "
                                          "yourself, or switch its supply off and on.")},
    RefusalText{"other-rates", QT_TRANSLATE_NOOP("text", "the servos do not talk at one rate"),
                QT_TRANSLATE_NOOP("text", "Nobody on the wire can be heard at two baud rates at "
                                          "the same time."),
                QT_TRANSLATE_NOOP("text", "Choose servos of one baud rate, or set them to the "
                                          "same one.")},
    RefusalText{"release-limit",
                QT_TRANSLATE_NOOP("text", "its angle limits leave no way back from the stall"),
                QT_TRANSLATE_NOOP("text", "A goal away from the stall would lie outside them."),
                QT_TRANSLATE_NOOP("text", "Widen the limits, or switch its supply off and on.")},
};

constexpr std::array badArgument{
    RefusalText{"same-ends", QT_TRANSLATE_NOOP("text", "start and end are the same place"),
                QT_TRANSLATE_NOOP("text", "There would be no way to measure on."),
                QT_TRANSLATE_NOOP("text", "Give two different places.")},
    RefusalText{"no-step", QT_TRANSLATE_NOOP("text", "the step is 0"),
                QT_TRANSLATE_NOOP("text", "With it the end would never be reached."),
                QT_TRANSLATE_NOOP("text", "Give a step of 1 or more.")},
    RefusalText{"negative-step", QT_TRANSLATE_NOOP("text", "the step is negative"),
                QT_TRANSLATE_NOOP("text", "The path runs from the start to the end and back, so "
                                          "its step has no direction."),
                QT_TRANSLATE_NOOP("text", "Give a step of 1 or more, and swap start and end for "
                                          "the other direction.")},
    RefusalText{"step-too-long", QT_TRANSLATE_NOOP("text", "the step is longer than the whole way"),
                QT_TRANSLATE_NOOP("text", "Start and end are nearer to each other than that."),
                QT_TRANSLATE_NOOP("text", "Give a smaller step, or a longer way.")},
    RefusalText{"no-points", QT_TRANSLATE_NOOP("text", "the list has fewer than two targets"),
                QT_TRANSLATE_NOOP("text", "A test goes from one place to another."),
                QT_TRANSLATE_NOOP("text", "Put at least two lines with a target into the file.")},
    RefusalText{"no-pause", QT_TRANSLATE_NOOP("text", "the delay is 0"),
                QT_TRANSLATE_NOOP("text", "The servo would be turned round before it has moved."),
                QT_TRANSLATE_NOOP("text", "Give the time a move needs and some more, or a dwell "
                                          "after arrival.")},
    RefusalText{"no-end", QT_TRANSLATE_NOOP("text", "the test would never end"),
                QT_TRANSLATE_NOOP("text", "Neither cycles nor a duration are given."),
                QT_TRANSLATE_NOOP("text", "Give a number of cycles or a duration.")},
    RefusalText{"no-period", QT_TRANSLATE_NOOP("text", "the sine has no period"),
                QT_TRANSLATE_NOOP("text", "Nothing says how fast it is to be followed."),
                QT_TRANSLATE_NOOP("text", "Give the seconds of one period.")},
    RefusalText{"no-size", QT_TRANSLATE_NOOP("text", "the step is 0"),
                QT_TRANSLATE_NOOP("text", "There would be nothing to answer to."),
                QT_TRANSLATE_NOOP("text", "Give a step of 1 or more, or a negative one.")},
    RefusalText{"no-hold", QT_TRANSLATE_NOOP("text", "the time from goal to goal is out of reach"),
                QT_TRANSLATE_NOOP("text", "Every reading of a response is kept, for ten seconds "
                                          "at most."),
                QT_TRANSLATE_NOOP("text", "Give up to ten seconds, or none: then it is worked "
                                          "out.")},
    RefusalText{"no-repeats", QT_TRANSLATE_NOOP("text", "the number of repeats is out of reach"),
                QT_TRANSLATE_NOOP("text", "Every reading is kept, of fifty steps there and back "
                                          "at most."),
                QT_TRANSLATE_NOOP("text", "Give 1 to 50.")},
    RefusalText{"no-gain", QT_TRANSLATE_NOOP("text", "this register is none that can be tried"),
                QT_TRANSLATE_NOOP("text", "A trial sets gains, startup force, integral limit and "
                                          "dead zones, as far as the servo has them."),
                QT_TRANSLATE_NOOP("text", "Write other registers in the memory table.")},
    RefusalText{"nothing-read", QT_TRANSLATE_NOOP("text", "nothing is being read"),
                QT_TRANSLATE_NOOP("text", "There is nothing that could be recorded."),
                QT_TRANSLATE_NOOP("text", "Connect, select a servo and choose curves first.")},
};

constexpr std::array held{
    RefusalText{"test", QT_TRANSLATE_NOOP("text", "a test has the bus to itself"),
                QT_TRANSLATE_NOOP("text", "Anything else on the wire would spoil what is being "
                                          "measured."),
                QT_TRANSLATE_NOOP("text", "Wait until the test has ended, or stop it.")},
    RefusalText{"other-program",
                QT_TRANSLATE_NOOP("text", "this change is still under way in another program"),
                QT_TRANSLATE_NOOP("text", "The program that began it is still running."),
                QT_TRANSLATE_NOOP("text", "Wait until that program has finished. If it is stopped "
                                          "before, the change can be finished or undone here.")},
};

constexpr std::array preempted{
    RefusalText{"torque-first",
                QT_TRANSLATE_NOOP("text", "the emergency stop keeps it from moving"),
                QT_TRANSLATE_NOOP("text", "Torque was taken off the whole bus and has not been "
                                          "switched on again since."),
                QT_TRANSLATE_NOOP("text", "Make sure that nothing can move, switch torque on "
                                          "first, then start again.")},
};

constexpr std::array consent{
    RefusalText{"turns", QT_TRANSLATE_NOOP("text", "writing this turns the shaft at once"),
                QT_TRANSLATE_NOOP("text", "The servo follows the new value as soon as it has it."),
                QT_TRANSLATE_NOOP("text", "Keep clear of the mechanism, then repeat the write with "
                                          "your explicit consent.")},
    RefusalText{"release-moves", QT_TRANSLATE_NOOP("text", "releasing this alarm moves the shaft"),
                QT_TRANSLATE_NOOP("text", "An overload is released by a goal away from the "
                                          "stall, and by nothing else."),
                QT_TRANSLATE_NOOP("text", "Keep clear of the mechanism, then ask again with your "
                                          "explicit consent.")},
    RefusalText{"release-energises",
                QT_TRANSLATE_NOOP("text", "releasing this alarm switches torque on"),
                QT_TRANSLATE_NOOP("text", "An overcurrent is released by a new goal, and by "
                                          "nothing else."),
                QT_TRANSLATE_NOOP("text", "Remove the cause and keep clear of the mechanism, then "
                                          "ask again with your explicit consent.")},
    RefusalText{"alarm-changed",
                QT_TRANSLATE_NOOP("text", "the alarm is no longer the one you agreed to clear"),
                QT_TRANSLATE_NOOP("text", "The servo's state has changed in between."),
                QT_TRANSLATE_NOOP("text", "Look at the alarm again, then decide.")},
};

constexpr std::array refused{
    RefusalText{"not-restarted", QT_TRANSLATE_NOOP("text", "it did not restart"),
                QT_TRANSLATE_NOOP("text", "It answers, and its RAM is unchanged: it ignores the "
                                          "restart command, or never received it."),
                QT_TRANSLATE_NOOP("text", "Switch its supply off and on.")},
    RefusalText{"restart-acknowledged",
                QT_TRANSLATE_NOOP("text", "it acknowledged the restart but did not restart"),
                QT_TRANSLATE_NOOP("text", "It answers, and its RAM is unchanged."),
                QT_TRANSLATE_NOOP("text", "Switch its supply off and on.")},
    RefusalText{"restart-unproven",
                QT_TRANSLATE_NOOP("text", "it could not be proven that it restarted"),
                QT_TRANSLATE_NOOP("text", "It answers, but nothing shows a restart: it ignored "
                                          "the command, or started too quickly to be noticed."),
                QT_TRANSLATE_NOOP("text", "Switch its supply off and on to be sure.")},
    RefusalText{"no-start", QT_TRANSLATE_NOOP("text", "it did not reach the start of the test"),
                QT_TRANSLATE_NOOP("text", "It is blocked, too weak or too slow, or its limits "
                                          "lie before that place."),
                QT_TRANSLATE_NOOP("text", "Free its way, then look at torque limit, speed and "
                                          "alarms.")},
    RefusalText{"trial-lost", QT_TRANSLATE_NOOP("text", "it restarted before its first step"),
                QT_TRANSLATE_NOOP("text", "Its power failed for a moment, and with that the values "
                                          "on trial were gone: it moved with its own."),
                QT_TRANSLATE_NOOP("text", "Look at plug and supply, then run the step again.")},
    RefusalText{"mode-changed", QT_TRANSLATE_NOOP("text", "its operating mode is another one now"),
                QT_TRANSLATE_NOOP("text", "Something else has switched it. In the new mode this "
                                          "goal would mean something else."),
                QT_TRANSLATE_NOOP("text", "Look at the mode shown now, then give a goal for it.")},
    RefusalText{"forget-held",
                QT_TRANSLATE_NOOP("text", "a goal that waits in the servo could not be removed"),
                QT_TRANSLATE_NOOP("text", "The next Execute would start it, whoever sends it."),
                QT_TRANSLATE_NOOP("text", "Switch the servo off and on, then it has forgotten "
                                          "the goal.")},
    RefusalText{"too-many-turns",
                QT_TRANSLATE_NOOP("text", "this step would lead beyond ±7.5 turns"),
                QT_TRANSLATE_NOOP("text", "The servo counts no further; the steps made since it "
                                          "was connected are added up here."),
                QT_TRANSLATE_NOOP("text", "Step back the other way.")},
};

constexpr std::array uncertain{
    RefusalText{"restarted",
                QT_TRANSLATE_NOOP("text", "it restarted or was exchanged in the middle, so it is "
                                          "unknown whether the value is kept"),
                QT_TRANSLATE_NOOP("text", "Its supply failed for a moment, or another servo was "
                                          "plugged in under this ID."),
                QT_TRANSLATE_NOOP("text", "Check plug and supply, connect the servo that was "
                                          "written to, then look at the open change (%recover).")},
    RefusalText{"nothing-changed",
                QT_TRANSLATE_NOOP("text", "it did not acknowledge, and every value is as before, "
                                          "so it is unknown whether it did it"),
                QT_TRANSLATE_NOOP("text", "Its firmware ignores this command, or its settings "
                                          "were the defaults already."),
                QT_TRANSLATE_NOOP("text", "Compare its memory table with the defaults, and write "
                                          "what differs.")},
};

template <typename List>
const RefusalText* findIn(const List& list, const QString& detail)
{
    for (const RefusalText& words : list) {
        if (detail == QLatin1String(words.detail))
            return &words;
    }
    return nullptr;
}
} // namespace

QString heldByStop(const base::Error& error)
{
    return error.code == base::ErrorCode::Preempted ? error.detail.section(QLatin1Char(' '), 1)
                                                    : QString();
}

QString heldGoals(const base::Error& error)
{
    const bool several = error.code == base::ErrorCode::Refused &&
                         error.detail.startsWith(QLatin1String("forget-held "));
    return several ? error.detail.section(QLatin1Char(' '), 1) : QString();
}

const RefusalText* refusalText(const base::Error& error)
{
    if (const RefusalText* words = serverText(error))
        return words;
    if (const RefusalText* words = historyText(error))
        return words;
    if (error.code == base::ErrorCode::NotSupported)
        return findIn(notSupported, error.detail);
    if (error.code == base::ErrorCode::NeedsConsent)
        return findIn(consent, error.detail);
    if (error.code == base::ErrorCode::Refused)
        return findIn(refused, heldGoals(error).isEmpty()
                                   ? error.detail
                                   : error.detail.section(QLatin1Char(' '), 0, 0));
    if (error.code == base::ErrorCode::Uncertain)
        return findIn(uncertain, error.detail);
    if (error.code == base::ErrorCode::Preempted)
        return findIn(preempted, error.detail.section(QLatin1Char(' '), 0, 0));
    if (error.code == base::ErrorCode::Held)
        return findIn(held, error.detail);
    if (error.code == base::ErrorCode::BadArgument)
        return findIn(badArgument, error.detail);
    return nullptr;
}
} // namespace text

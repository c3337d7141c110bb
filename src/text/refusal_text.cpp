// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/refusal_text.h"

#include "text/history_text.h"
#include "text/server_text.h"
#include "text/text_table.h"

#include <array>

namespace text {
namespace {
constexpr std::array notSupported{
    RefusalText{
        "not-position", QT_TRANSLATE_NOOP("text", "the servo is not in a position mode"),
        QT_TRANSLATE_NOOP("text", "Position goals have no meaning in the present mode."),
        QT_TRANSLATE_NOOP("text",
                          "Select \"Switch to position mode\" for this test (--switch-mode on the "
                          "command line), or switch the servo to position mode yourself first.")},
    RefusalText{"fixed-rate", QT_TRANSLATE_NOOP("text", "the baud rate cannot be changed"),
                QT_TRANSLATE_NOOP("text", "This family has a fixed baud rate and no command to "
                                          "change it."),
                QT_TRANSLATE_NOOP("text", "Set the other servos and the port to this baud rate.")},
    RefusalText{"no-reboot", QT_TRANSLATE_NOOP("text", "the servo has no reboot command"),
                QT_TRANSLATE_NOOP("text", "This family has no such command."),
                QT_TRANSLATE_NOOP("text", "Turn the power supply off and on.")},
    RefusalText{"no-firmware-update",
                QT_TRANSLATE_NOOP("text", "the firmware of this servo cannot be updated here"),
                QT_TRANSLATE_NOOP("text", "Only the bootloader of Feetech servos is known."),
                QT_TRANSLATE_NOOP("text", "Use the manufacturer's software.")},
    RefusalText{"rescue-not-alone",
                QT_TRANSLATE_NOOP("text", "a servo replies, so the rescue cannot start"),
                QT_TRANSLATE_NOOP(
                    "text", "Another servo is connected, or the servo to rescue has its firmware."),
                QT_TRANSLATE_NOOP(
                    "text", "Connect only the servo to rescue, and turn its supply off first.")},
    RefusalText{"several-rescued",
                QT_TRANSLATE_NOOP("text", "several servos reply after the rescue"),
                QT_TRANSLATE_NOOP("text", "Their supply came on together."),
                QT_TRANSLATE_NOOP("text", "Compare the firmware versions of these servos.")},
    RefusalText{"joint-lost-track",
                QT_TRANSLATE_NOOP("text", "readings of this joint were missing while it moved"),
                QT_TRANSLATE_NOOP("text", "It may have turned by half a turn meanwhile, so its "
                                          "range is not known."),
                QT_TRANSLATE_NOOP("text", "Record this joint again.")},
    RefusalText{
        "joint-full-turn", QT_TRANSLATE_NOOP("text", "this joint turns through a full turn"),
        QT_TRANSLATE_NOOP("text", "In this arm it has two stops: another servo has its ID, "
                                  "or the horn is loose."),
        QT_TRANSLATE_NOOP("text", "Check the IDs and the horn, or make the joint continuous "
                                  "in a file of your own.")},
    RefusalText{"joint-in-step-mode",
                QT_TRANSLATE_NOOP("text", "this joint is in step mode and reports no position"),
                QT_TRANSLATE_NOOP("text", "Another program has set the mode."),
                QT_TRANSLATE_NOOP("text", "Set the position mode first.")},
    RefusalText{"calibration-out-of-range",
                QT_TRANSLATE_NOOP("text", "this servo cannot hold the offset or the limits"),
                QT_TRANSLATE_NOOP("text", "The file is for another arm, or for other servos."),
                QT_TRANSLATE_NOOP("text", "Calibrate the arm, or select another file.")},
    RefusalText{"joint-not-recorded",
                QT_TRANSLATE_NOOP("text", "the range of this joint is not known"),
                QT_TRANSLATE_NOOP("text", "The joint was not moved through its range."),
                QT_TRANSLATE_NOOP("text", "Move the joint from stop to stop by hand.")},
    RefusalText{
        "joint-beyond-turn",
        QT_TRANSLATE_NOOP("text", "the range does not fit into one turn of the encoder"),
        QT_TRANSLATE_NOOP("text", "The middle pose is too far from the middle of the range."),
        QT_TRANSLATE_NOOP("text", "End in a pose closer to the middle, or use the middle of "
                                  "the range.")},
    RefusalText{"no-position-limits",
                QT_TRANSLATE_NOOP("text", "this servo has no position limits"),
                QT_TRANSLATE_NOOP("text", "Its family has no such registers."),
                QT_TRANSLATE_NOOP("text", "Leave the joint out of the arm.")},
    RefusalText{"no-torque-limit",
                QT_TRANSLATE_NOOP("text", "the torque of this servo cannot be limited"),
                QT_TRANSLATE_NOOP("text", "Its family has no such register."),
                QT_TRANSLATE_NOOP("text", "Leave the joint out of the move test.")},
    RefusalText{"no-lerobot-settings",
                QT_TRANSLATE_NOOP("text", "no LeRobot settings are known for this family"),
                QT_TRANSLATE_NOOP("text", "Only those of STS and SMS servos are known."),
                QT_TRANSLATE_NOOP("text", "Leave the joint out of the arm.")},
    RefusalText{"firmware-kind",
                QT_TRANSLATE_NOOP("text", "this is not a firmware file for bus servos"),
                QT_TRANSLATE_NOOP("text", "Only *.bin files are for bus servos; *.hex, *.mbin, "
                                          "*.fbin and *.xbin are for other devices."),
                QT_TRANSLATE_NOOP("text", "Select the vendor's *.bin file for this model.")},
    RefusalText{"firmware-size",
                QT_TRANSLATE_NOOP("text", "this file does not have the size of a firmware file"),
                QT_TRANSLATE_NOOP("text", "A firmware file has 64 to 65,535 bytes."),
                QT_TRANSLATE_NOOP("text", "Download the file again.")},
    RefusalText{"no-restore",
                QT_TRANSLATE_NOOP("text", "the servo cannot reset itself to factory defaults"),
                QT_TRANSLATE_NOOP("text", "This family has no such command."),
                QT_TRANSLATE_NOOP("text", "Write the default values one by one.")},
    RefusalText{
        "no-sync", QT_TRANSLATE_NOOP("text", "the servo cannot share a packet with other servos"),
        QT_TRANSLATE_NOOP("text", "This family has no packet that addresses several servos."),
        QT_TRANSLATE_NOOP("text", "Send the goals one by one.")},
    RefusalText{"no-async", QT_TRANSLATE_NOOP("text", "the servo cannot store a goal for later"),
                QT_TRANSLATE_NOOP("text", "This family does not support asynchronous writes."),
                QT_TRANSLATE_NOOP("text", "Send the goals one by one.")},
    RefusalText{
        "other-mode",
        QT_TRANSLATE_NOOP("text", "the servo's mode differs from that of the first servo"),
        QT_TRANSLATE_NOOP("text", "The same goal would have a different meaning for this servo."),
        QT_TRANSLATE_NOOP("text", "Switch all servos to the same mode first.")},
    RefusalText{
        "mode-first", QT_TRANSLATE_NOOP("text", "a mode and its goal cannot be written together"),
        QT_TRANSLATE_NOOP(
            "text", "A mode change first sets the goal to zero to prevent unexpected movement."),
        QT_TRANSLATE_NOOP("text", "Change the mode first, then send the goal.")},
    RefusalText{"speed-by-time", QT_TRANSLATE_NOOP("text", "the servo has no speed setting"),
                QT_TRANSLATE_NOOP("text", "The travel time determines the speed."),
                QT_TRANSLATE_NOOP("text", "Use a travel time instead.")},
    RefusalText{
        "not-readable", QT_TRANSLATE_NOOP("text", "no reply to this read request"),
        QT_TRANSLATE_NOOP(
            "text", "Some models in this family do not have this command; the connection is good."),
        QT_TRANSLATE_NOOP("text", "You can ignore this value.")},
    RefusalText{"with-goal",
                QT_TRANSLATE_NOOP("text", "the time must be written together with "
                                          "a goal"),
                QT_TRANSLATE_NOOP("text", "One command contains both goal and time, so writing "
                                          "only the time would send the last goal again."),
                QT_TRANSLATE_NOOP("text", "Write the goal and the time together.")},
    RefusalText{
        "always-kept",
        QT_TRANSLATE_NOOP("text", "this setting is always kept after "
                                  "power-off"),
        QT_TRANSLATE_NOOP(
            "text", "The servo stores the value immediately and has no lock to prevent this."),
        QT_TRANSLATE_NOOP("text", "Write the value permanently, then write the old value back.")},
    RefusalText{
        "no-led", QT_TRANSLATE_NOOP("text", "the servo has no controllable LED"),
        QT_TRANSLATE_NOOP("text", "This family's memory table has no LED register."),
        QT_TRANSLATE_NOOP(
            "text",
            "With torque off, turn a shaft by hand and check which servo's position changes.")},
    RefusalText{
        "factory-led",
        QT_TRANSLATE_NOOP("text", "the servo's LED setting is one of the factory values"),
        QT_TRANSLATE_NOOP(
            "text",
            "Blinking the LED would require unlocking and rewriting these values many times."),
        QT_TRANSLATE_NOOP(
            "text",
            "With torque off, turn a shaft by hand and check which servo's position changes.")},
    RefusalText{
        "release-mode",
        QT_TRANSLATE_NOOP(
            "text",
            "in this mode, the servo cannot back off from the stalled position by a small amount"),
        QT_TRANSLATE_NOOP("text", "Only turning in the opposite direction clears an overload "
                                  "alarm; in this mode, the shaft would keep turning."),
        QT_TRANSLATE_NOOP("text", "Remove the load and send a command in the opposite direction, "
                                  "or turn the power supply off and on.")},
    RefusalText{
        "release-direction", QT_TRANSLATE_NOOP("text", "the direction of the stall is unknown"),
        QT_TRANSLATE_NOOP("text",
                          "The servo is at its goal and is not pushing in either direction."),
        QT_TRANSLATE_NOOP("text", "Remove the load and set a goal away from the stalled position, "
                                  "or turn the power supply off and on.")},
    RefusalText{
        "other-rates", QT_TRANSLATE_NOOP("text", "the servos use different baud rates"),
        QT_TRANSLATE_NOOP("text", "One bus cannot run at two baud rates at the same time."),
        QT_TRANSLATE_NOOP(
            "text", "Select servos with the same baud rate, or set them all to one baud rate.")},
    RefusalText{
        "release-limit",
        QT_TRANSLATE_NOOP(
            "text", "the servo's angle limits do not allow moving away from the stalled position"),
        QT_TRANSLATE_NOOP("text",
                          "Any goal away from the stalled position would be outside the limits."),
        QT_TRANSLATE_NOOP("text", "Widen the limits, or turn the power supply off and on.")},
};

constexpr std::array badArgument{
    RefusalText{"same-ends", QT_TRANSLATE_NOOP("text", "start and end are the same position"),
                QT_TRANSLATE_NOOP("text", "There would be no travel to measure."),
                QT_TRANSLATE_NOOP("text", "Enter two different positions.")},
    RefusalText{"no-step", QT_TRANSLATE_NOOP("text", "the step is 0"),
                QT_TRANSLATE_NOOP("text", "The end would never be reached."),
                QT_TRANSLATE_NOOP("text", "Enter a step of 1 or more.")},
    RefusalText{
        "negative-step", QT_TRANSLATE_NOOP("text", "the step is negative"),
        QT_TRANSLATE_NOOP("text", "The path runs in both directions, so the step has no sign."),
        QT_TRANSLATE_NOOP(
            "text", "Enter a step of 1 or more; to reverse the direction, swap start and end.")},
    RefusalText{
        "step-too-long",
        QT_TRANSLATE_NOOP("text", "the step is larger than the distance from start to end"),
        QT_TRANSLATE_NOOP("text", "Start and end are closer together than one step."),
        QT_TRANSLATE_NOOP("text", "Use a smaller step, or move start and end farther apart.")},
    RefusalText{"no-points", QT_TRANSLATE_NOOP("text", "the list has fewer than two goals"),
                QT_TRANSLATE_NOOP("text", "A test moves the servo between at least two positions."),
                QT_TRANSLATE_NOOP("text", "Put at least two goals in the file, one per line.")},
    RefusalText{
        "no-pause", QT_TRANSLATE_NOOP("text", "the delay is 0"),
        QT_TRANSLATE_NOOP("text", "The servo would be sent back before it has moved."),
        QT_TRANSLATE_NOOP(
            "text", "Enter a delay longer than one move takes, or use a dwell after arrival.")},
    RefusalText{"no-end", QT_TRANSLATE_NOOP("text", "the test would never end"),
                QT_TRANSLATE_NOOP("text", "Neither a number of cycles nor a duration is set."),
                QT_TRANSLATE_NOOP("text", "Set a number of cycles or a duration.")},
    RefusalText{"no-period", QT_TRANSLATE_NOOP("text", "the period of the sine wave is not set"),
                QT_TRANSLATE_NOOP("text", "The speed of the movement is undefined."),
                QT_TRANSLATE_NOOP("text", "Enter the period in seconds.")},
    RefusalText{"no-size", QT_TRANSLATE_NOOP("text", "the step is 0"),
                QT_TRANSLATE_NOOP("text", "With a step of 0, there is no response to measure."),
                QT_TRANSLATE_NOOP("text", "Enter a nonzero step; it may be negative.")},
    RefusalText{
        "no-hold", QT_TRANSLATE_NOOP("text", "the time between goals is out of range"),
        QT_TRANSLATE_NOOP(
            "text",
            "All readings of a response are stored, so the time is limited to ten seconds."),
        QT_TRANSLATE_NOOP(
            "text",
            "Enter ten seconds or less, or leave the field empty to use the calculated time.")},
    RefusalText{
        "no-repeats", QT_TRANSLATE_NOOP("text", "the number of repeats is out of range"),
        QT_TRANSLATE_NOOP(
            "text",
            "All readings are stored, so a run is limited to fifty steps in each direction."),
        QT_TRANSLATE_NOOP("text", "Enter a number from 1 to 50.")},
    RefusalText{"no-gain", QT_TRANSLATE_NOOP("text", "this register cannot be used in a trial"),
                QT_TRANSLATE_NOOP("text",
                                  "A trial can change only the gains, the startup force, the "
                                  "integral limit and the dead zones, if the servo has them."),
                QT_TRANSLATE_NOOP("text", "Use the memory table to write other registers.")},
    RefusalText{"nothing-read", QT_TRANSLATE_NOOP("text", "no data is being read"),
                QT_TRANSLATE_NOOP("text", "There is nothing to record."),
                QT_TRANSLATE_NOOP("text", "Connect, select a servo and choose channels first.")},
};

constexpr std::array held{
    RefusalText{"test", QT_TRANSLATE_NOOP("text", "a test has exclusive use of the bus"),
                QT_TRANSLATE_NOOP("text", "Other communication on the bus would distort the "
                                          "measurement."),
                QT_TRANSLATE_NOOP("text", "Wait until the test ends, or stop it.")},
    RefusalText{"other-program",
                QT_TRANSLATE_NOOP("text", "another program is still working on this change"),
                QT_TRANSLATE_NOOP("text", "The program that started the change is still running."),
                QT_TRANSLATE_NOOP("text", "Wait until the other program has finished. If it exits "
                                          "early, you can finish or undo the change here.")},
};

constexpr std::array preempted{
    RefusalText{"torque-first",
                QT_TRANSLATE_NOOP("text", "movement is blocked after the emergency stop"),
                QT_TRANSLATE_NOOP("text", "Torque was turned off on the whole bus and has not "
                                          "been turned on again."),
                QT_TRANSLATE_NOOP("text", "Make sure that nothing can move unexpectedly, turn "
                                          "torque on, then start again.")},
};

constexpr std::array consent{
    RefusalText{
        "turns", QT_TRANSLATE_NOOP("text", "writing this value moves the shaft immediately"),
        QT_TRANSLATE_NOOP("text", "The servo follows the new value immediately."),
        QT_TRANSLATE_NOOP(
            "text",
            "Keep clear of the mechanism, then repeat the write and confirm it explicitly.")},
    RefusalText{
        "free-turning",
        QT_TRANSLATE_NOOP("text",
                          "with both angle limits at 0, the movement of the shaft is not limited"),
        QT_TRANSLATE_NOOP("text", "Without limits, the shaft can turn past any position."),
        QT_TRANSLATE_NOOP("text", "Keep clear of the mechanism, then repeat the write and "
                                  "confirm it explicitly.")},
    RefusalText{
        "release-moves", QT_TRANSLATE_NOOP("text", "clearing this alarm moves the shaft"),
        QT_TRANSLATE_NOOP("text",
                          "Only a goal away from the stalled position clears an overload alarm."),
        QT_TRANSLATE_NOOP(
            "text",
            "Keep clear of the mechanism, then repeat this action and confirm it explicitly.")},
    RefusalText{"release-energises",
                QT_TRANSLATE_NOOP("text", "clearing this alarm turns torque on"),
                QT_TRANSLATE_NOOP("text", "Only a new goal clears an overcurrent alarm."),
                QT_TRANSLATE_NOOP("text", "Remove the cause and keep clear of the mechanism, then "
                                          "repeat this action and confirm it explicitly.")},
    RefusalText{
        "alarm-changed",
        QT_TRANSLATE_NOOP("text", "the alarm has changed since you confirmed clearing it"),
        QT_TRANSLATE_NOOP("text", "The servo's state has changed in the meantime."),
        QT_TRANSLATE_NOOP("text", "Check the alarm again, then decide whether to clear it.")},
};

constexpr std::array refused{
    RefusalText{"not-restarted", QT_TRANSLATE_NOOP("text", "the servo did not reboot"),
                QT_TRANSLATE_NOOP("text", "The servo replies, and its RAM is unchanged: the servo "
                                          "ignored or did not receive the reboot command."),
                QT_TRANSLATE_NOOP("text", "Turn the power supply off and on.")},
    RefusalText{
        "restart-acknowledged",
        QT_TRANSLATE_NOOP("text", "the servo acknowledged the reboot command but did not reboot"),
        QT_TRANSLATE_NOOP("text", "The servo replies, and its RAM is unchanged."),
        QT_TRANSLATE_NOOP("text", "Turn the power supply off and on.")},
    RefusalText{"restart-unproven", QT_TRANSLATE_NOOP("text", "the reboot could not be confirmed"),
                QT_TRANSLATE_NOOP("text",
                                  "The servo replies but shows no sign of a reboot: it ignored the "
                                  "command, or rebooted too quickly to be noticed."),
                QT_TRANSLATE_NOOP("text", "To be sure, turn the power supply off and on.")},
    RefusalText{
        "no-start",
        QT_TRANSLATE_NOOP("text", "the servo did not reach the start position of the test"),
        QT_TRANSLATE_NOOP(
            "text",
            "The servo is blocked, too weak or too slow, or its limits prevent the movement."),
        QT_TRANSLATE_NOOP("text",
                          "Remove the obstacle, then check the torque limit, speed and alarms.")},
    RefusalText{
        "trial-lost", QT_TRANSLATE_NOOP("text", "the servo rebooted before its first step"),
        QT_TRANSLATE_NOOP("text", "The power supply was interrupted and the trial values were "
                                  "lost, so the servo moved with its old values."),
        QT_TRANSLATE_NOOP(
            "text", "Check the plug and the power supply, then measure the step response again.")},
    RefusalText{
        "mode-changed", QT_TRANSLATE_NOOP("text", "the servo's operating mode has changed"),
        QT_TRANSLATE_NOOP("text", "Another program has changed the mode. In the new mode, this "
                                  "goal has a different meaning."),
        QT_TRANSLATE_NOOP("text",
                          "Check which mode is now shown, then send a goal for that mode.")},
    RefusalText{
        "forget-held",
        QT_TRANSLATE_NOOP("text", "a goal waiting in the servo could not be removed"),
        QT_TRANSLATE_NOOP(
            "text",
            "The next Execute command, from any program, will move the servo to this goal."),
        QT_TRANSLATE_NOOP("text", "Turn the servo off and on to discard this goal.")},
    RefusalText{"too-many-turns", QT_TRANSLATE_NOOP("text", "this step would go beyond ±7.5 turns"),
                QT_TRANSLATE_NOOP("text", "The servo cannot count beyond ±7.5 turns. The displayed "
                                          "total includes all steps since you connected."),
                QT_TRANSLATE_NOOP("text", "Step in the opposite direction.")},
};

constexpr std::array noReply{
    RefusalText{"no-bootloader", QT_TRANSLATE_NOOP("text", "no bootloader has replied"),
                QT_TRANSLATE_NOOP("text", "The servo's supply was not turned off and on in time, "
                                          "or the data wire is loose."),
                QT_TRANSLATE_NOOP("text", "Start again, and turn the servo's supply off and on "
                                          "while the program waits.")},
};

constexpr std::array uncertain{
    RefusalText{
        "restarted",
        QT_TRANSLATE_NOOP("text", "the servo rebooted or was replaced during the write, so it is "
                                  "unknown whether the value was saved"),
        QT_TRANSLATE_NOOP(
            "text",
            "The power supply was interrupted, or another servo with this ID was connected."),
        QT_TRANSLATE_NOOP("text", "Check the plug and the power supply, connect the original "
                                  "servo, then check the unfinished change (%recover).")},
    RefusalText{
        "nothing-changed",
        QT_TRANSLATE_NOOP("text", "the servo did not acknowledge the command, and all values are "
                                  "unchanged, so it is unknown whether the command was executed"),
        QT_TRANSLATE_NOOP(
            "text",
            "The firmware ignores this command, or all settings already had their default values."),
        QT_TRANSLATE_NOOP("text", "Compare the servo's memory table with the defaults, and write "
                                  "the values that differ.")},
};

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
        return entryFor(notSupported, error.detail);
    if (error.code == base::ErrorCode::NeedsConsent)
        return entryFor(consent, error.detail);
    if (error.code == base::ErrorCode::Refused)
        return entryFor(refused, heldGoals(error).isEmpty()
                                     ? error.detail
                                     : error.detail.section(QLatin1Char(' '), 0, 0));
    if (error.code == base::ErrorCode::NoReply)
        return entryFor(noReply, error.detail);
    if (error.code == base::ErrorCode::Uncertain)
        return entryFor(uncertain, error.detail);
    if (error.code == base::ErrorCode::Preempted)
        return entryFor(preempted, error.detail.section(QLatin1Char(' '), 0, 0));
    if (error.code == base::ErrorCode::Held)
        return entryFor(held, error.detail);
    if (error.code == base::ErrorCode::BadArgument)
        return entryFor(badArgument, error.detail);
    return nullptr;
}
} // namespace text
